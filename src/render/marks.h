#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "cloth_mesh.h"
#include "contact_forces.h"
#include "drape/model/stencils.h"
#include "drape/session/comparison.h"
#include "drape/sim/frame_view.h"
#include "drawn_nodes.h"
#include "frame_data.h"
#include "gl.h"
#include "picture_target.h"
#include "solids.h"
#include "stream_buffer.h"

namespace drape {

/// What explains the picture: pins and what the hand holds; as far as the settings ask for them, particles and springs,
/// contacts, bounds; a ring about the particle that has diverged first, a thick line along the worst of its
/// springs, and one along the unstable mode's.
class Marks {
public:
    Marks(Gl& gl, StreamBuffer& stream)
        : gl_(gl),
          springs_(gl, stream, Region::Cloth, cloth_layout()),
          contacts_(gl, stream, Region::Contacts, {sizeof(ContactMark), {{0, 3}, {1, 3}, {2, 3}}, true}),
          spheres_(gl, stream, Region::Spheres, {sizeof(Outlines::Sphere), {{0, 3}, {1, 1}, {2, 1, GL_INT}}, true}),
          edges_(gl, stream, Region::Edges, {sizeof(Outlines::End), {{0, 3}, {1, 1, GL_INT}}}) {}

    /// Collects what will be drawn.
    /// @param crosses lines that are drawn with those of the bounding volumes
    void fill(const FrameView& view, std::span<const Outlines::Edge> crosses, StreamBuffer& stream) {
        const ViewSettings& shown = view.settings->view;
        show_particles_ = shown.particles;
        contact_count_ = particle_count_ = 0;
        show_pins_ = false;
        bounds_.spheres.clear();
        bounds_.edges.clear();
        for (const ClothView& cloth : view.cloths) {
            particle_count_ += cloth.model.grid.particles();
            show_pins_ = show_pins_ || (cloth.model.inverse_mass == 0).any();
            if (shown.contacts) contact_count_ += static_cast<int>(cloth.contacts.size());
            if (!shown.bounds) continue;
            const TouchedCells touched(cloth, *view.report);
            for (const NodeView& node : shown_nodes(view, *cloth.hierarchy)) {
                append_outline(node.volume, cloth.hierarchy->slack(), touched.state_of(node), bounds_);
            }
        }
        const ClothModel& model = view.cloths.front().model;
        spacing_ = static_cast<float>(std::min(model.hx, model.hy));
        if (show_particles_) index_springs(view);
        collect_compared(view);
        bounds_.edges.insert(bounds_.edges.end(), crosses.begin(), crosses.end());

        fill_contacts(view, stream);
        std::ranges::copy(bounds_.spheres, stream.room<Outlines::Sphere>(Region::Spheres, bounds_.spheres.size()));
        std::ranges::copy(bounds_.edges, stream.room<Outlines::Edge>(Region::Edges, bounds_.edges.size()));
    }

    /// Adds bounds, and what is compared; the rest is at solids, or anywhere.
    void add_to(PictureBounds& bounds) const {
        for (const Outlines::Sphere& sphere : bounds_.spheres) bounds.add(sphere.centre, sphere.radius);
        for (const Outlines::Edge& edge : bounds_.edges) {
            bounds.add(edge.from.point);
            bounds.add(edge.to.point);
        }
    }

    /// Adds the numbers of springs and of the segments of circles, and the particles' spacing.
    void add_to(FrameData& data) const {
        data.counts[0] = spring_counts_[0];
        data.counts[1] = spring_counts_[1];
        data.counts[2] = segments();
        data.shadow[1] = spacing_;
    }

    /// Over the solids, and last of all that has a depth; blending is on.
    /// @param failed whether the run has diverged at a particle, which is marked over all that is before it
    void draw(bool failed) {
        if (show_particles_) {
            const auto [structural, shear, bend] = spring_counts_;
            const int plain = structural + shear;
            spring_program_.use();
            springs_.bind();
            gl_(glVertexAttrib1f, 4u, 0.0f);
            gl_.draw_elements(GL_LINES, 2 * plain);
            gl_(glVertexAttrib1f, 4u, bend_lift * spacing_);
            gl_.draw_elements(GL_LINES, 2 * bend, 2 * static_cast<std::size_t>(plain) * sizeof(std::uint32_t));
            particle_program_.use();
            gl_.draw_arrays(GL_POINTS, particle_count_);
        }
        if (show_pins_) draw_array(pin_program_, springs_, GL_POINTS, particle_count_, 1);
        if (contact_count_ > 0) draw_array(contact_program_, contacts_, GL_TRIANGLES, contact_vertices, contact_count_);
        const auto spheres = static_cast<int>(bounds_.spheres.size()), edges = static_cast<int>(bounds_.edges.size());
        if (spheres > 0) draw_seen_and_hidden(sphere_program_, spheres_, 2 * circles_per_sphere * segments(), spheres);
        if (edges > 0) draw_seen_and_hidden(edge_program_, edges_, 2 * edges, 1);
        if (failed) {
            failure_program_.use();
            gl_(glBindVertexArray, no_vertices_.name());
            gl_.draw_arrays(GL_TRIANGLES, 18);
        }
    }

    /// How far marks stand out of the box of what is drawn [pixel].
    [[nodiscard]] int room(const FrameData& data) const {
        // Half of a line's width, or of a pin's: the ring grows as in pin.vert, where it has a radius of 11; the rest
        // is for pins that are near
        const float scale = std::max(data.viewport.y() / 720, 0.6f * data.magnified.x());
        return static_cast<int>(std::ceil(show_pins_ ? 24 * scale : data.magnified.x() / 2));
    }

private:
    struct ContactMark {
        Eigen::Vector3f point, force;  // in full lengths of an arrow
        std::array<float, 4> colour;
    };

    static constexpr int circles_per_sphere = 4;
    static constexpr int contact_vertices = 15;
    static constexpr GLuint hidden_attribute = 5;  // of lines behind something: 1
    static constexpr float bend_lift = 0.22f;      // of the bend springs over the cloth, in spacings

    // Of the circles of a bounding sphere: fewer where there are many spheres
    [[nodiscard]] int segments() const {
        constexpr std::size_t vertices_wanted = 300'000;
        const std::size_t share =
            vertices_wanted / (2 * circles_per_sphere * std::max<std::size_t>(bounds_.spheres.size(), 1));
        return static_cast<int>(std::clamp<std::size_t>(share, 8, 48));
    }

    void collect_compared(const FrameView& view) {
        if (view.comparison == nullptr) return;
        const FrameView& other = view.comparison->other;
        for (std::size_t b = 0; b < std::min(view.balls.size(), other.balls.size()); ++b) {
            const Eigen::Vector4f ball = drawn_ball(other, b);
            constexpr Real seen = Real(1e-3);  // of its radius
            const Real apart = (ball.head<3>().cast<Real>() - view.balls[b].centre).norm();
            if (apart > seen * other.balls[b].radius) {
                bounds_.spheres.push_back({ball.head<3>(), ball.w(), NodeState::Compared});
            }
        }
        for (const ClothView& cloth : other.cloths) {
            const auto at = [&](int p) { return drawn_particle(cloth, other.blend, p); };
            for (std::size_t k = 0; k < 2; ++k) {
                const auto [di, dj] = spring_directions[k];
                SpringStencil{di, dj, {}, 0}.for_each(cloth.model.grid, [&](int a, int b) {
                    bounds_.edges.push_back({at(a), at(b), NodeState::Compared});
                });
            }
        }
    }

    void index_springs(const FrameView& view) {
        if (!update_kept(view.cloths, grids_, grid_of)) return;

        const SpringIndices springs = spring_indices(grids_);
        spring_counts_ = springs.counts;
        springs_.bind();
        fill_static(gl_, GL_ELEMENT_ARRAY_BUFFER, spring_indices_, springs.ends);
    }

    void fill_contacts(const FrameView& view, StreamBuffer& stream) const {
        auto* mark = stream.room<ContactMark>(Region::Contacts, static_cast<std::size_t>(contact_count_));
        if (contact_count_ == 0) return;
        const Real full = std::max(static_cast<Real>(full_force(view)), std::numeric_limits<Real>::min());
        for (const ClothView& cloth : view.cloths) {
            for (const ContactRow& contact : cloth.contacts) {
                const auto [force, hold] = force_of(view, contact);
                *mark++ = {contact.point(cloth.x).cast<float>(), (force / full).cast<float>(),
                           hold_looks[static_cast<std::size_t>(hold)].colour};
            }
        }
    }

    void draw_array(const Program& program, StreamArray& array, GLenum mode, int vertices, int instances) {
        program.use();
        array.bind();
        gl_.draw_arrays(mode, vertices, instances);
    }

    /// Lines, fainter where something is before them. Nothing that asks for depths may be drawn afterwards.
    void draw_seen_and_hidden(const Program& program, StreamArray& array, int vertices, int instances) {
        draw_array(program, array, GL_LINES, vertices, instances);
        gl_(glVertexAttrib1f, hidden_attribute, 1.0f);
        gl_(glDepthFunc, GL_GREATER);
        gl_.draw_arrays(GL_LINES, vertices, instances);
        gl_(glDepthFunc, GL_LEQUAL);
        gl_(glVertexAttrib1f, hidden_attribute, 0.0f);
    }

    Gl& gl_;
    Program spring_program_{gl_, "spring"}, particle_program_{gl_, "particle"}, pin_program_{gl_, "pin"},
        contact_program_{gl_, "contact"}, sphere_program_{gl_, "bounding_sphere", "node"},
        edge_program_{gl_, "edge", "node"}, failure_program_{gl_, "failure"};
    StreamArray springs_, contacts_, spheres_, edges_;
    VertexArray no_vertices_{gl_};  ///< core profile wants one, even where the shader makes the corners
    Buffer spring_indices_{gl_};
    std::vector<Grid> grids_;
    Outlines bounds_;  ///< and structural springs and balls of the other simulation, and strains of cells
    bool show_particles_ = false;
    bool show_pins_ = false;
    int particle_count_ = 0, contact_count_ = 0;
    std::array<int, 3> spring_counts_{};  ///< structural, shear, bend
    float spacing_ = 0;                   ///< of the particles of the first cloth [m]
};

}  // namespace drape
