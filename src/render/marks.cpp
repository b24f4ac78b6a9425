#include "marks.h"

#include <algorithm>
#include <cstddef>

#include "cloth_mesh.h"
#include "drape/model/stencils.h"
#include "drape/sim/comparison.h"
#include "solids.h"

namespace drape {

namespace {

struct ContactMark {
    float point[3];
    float normal[3];
};

struct SphereMark {
    float centre[3];
    float radius;
    float state;
};

/// An end of an edge.
struct EdgeMark {
    float point[3];
    float state;
};

constexpr int circles_per_sphere = 4;
constexpr int contact_vertices = 9;
constexpr GLuint hidden_attribute = 5;  // of lines behind something: 1
constexpr float bend_lift = 0.22f;      // of the bend springs over the cloth, in spacings

bool has_pins(const ClothView& cloth) {
    for (int p = 0; p < cloth.model.grid.particles(); ++p) {
        if (cloth.model.pinned(p)) return true;
    }
    return false;
}

void copy(const Vec3& from, float* to) {
    for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<float>(from[axis]);
}

}  // namespace

Marks::Marks(Gl& gl, StreamBuffer& stream)
    : gl_(gl),
      spring_program_(gl, "spring"),
      particle_program_(gl, "particle"),
      pin_program_(gl, "pin"),
      contact_program_(gl, "contact"),
      sphere_program_(gl, "bounding_sphere"),
      edge_program_(gl, "edge"),
      springs_(gl, stream, Region::Cloth, cloth_layout()),
      contacts_(
          gl, stream, Region::Contacts,
          {sizeof(ContactMark), {{0, 3, offsetof(ContactMark, point)}, {1, 3, offsetof(ContactMark, normal)}}, true}),
      spheres_(gl, stream, Region::Spheres,
               {sizeof(SphereMark),
                {{0, 3, offsetof(SphereMark, centre)},
                 {1, 1, offsetof(SphereMark, radius)},
                 {2, 1, offsetof(SphereMark, state)}},
                true}),
      edges_(gl, stream, Region::Edges,
             {sizeof(EdgeMark), {{0, 3, offsetof(EdgeMark, point)}, {1, 1, offsetof(EdgeMark, state)}}}),
      spring_indices_(gl) {}

int Marks::segments() const {
    constexpr std::size_t vertices_wanted = 300'000;
    const std::size_t share = vertices_wanted / (2 * circles_per_sphere * std::max<std::size_t>(sphere_count(), 1));
    return static_cast<int>(std::clamp<std::size_t>(share, 8, 48));
}

void Marks::need(const FrameView& view, StreamBuffer& stream) {
    const ViewSettings& shown = view.settings->view;
    show_particles_ = shown.particles;
    contact_count_ = particle_count_ = 0;
    show_pins_ = false;
    bounds_.clear();
    for (const ClothView& cloth : view.cloths) {
        particle_count_ += cloth.model.grid.particles();
        show_pins_ = show_pins_ || has_pins(cloth);
        if (shown.contacts) contact_count_ += static_cast<int>(cloth.contacts.size());
    }
    if (shown.bounds) collect_bounds(view);
    stream.need(Region::Contacts, static_cast<std::size_t>(contact_count_) * sizeof(ContactMark));
    collect_compared(view);
    stream.need(Region::Spheres, sphere_count() * sizeof(SphereMark));
    stream.need(Region::Edges, 2 * edge_count() * sizeof(EdgeMark));
}

void Marks::collect_compared(const FrameView& view) {
    compared_.clear();
    compared_balls_.clear();
    if (view.comparison == nullptr) return;
    const Real blend = view.comparison->blend;
    for (std::size_t b = 0; b < std::min(view.balls.size(), view.comparison->balls.size()); ++b) {
        const Ball &before = view.comparison->previous_balls[b], &now = view.comparison->balls[b];
        const Vec3 centre = (1 - blend) * before.centre + blend * now.centre;
        constexpr Real seen = Real(1e-3);  // of its radius
        if ((centre - view.balls[b].centre).norm() > seen * now.radius) compared_balls_.push_back({centre, now.radius});
    }
    for (const ClothView& cloth : view.comparison->cloths) {
        const auto at = [&](int p) -> Vec3 {
            return ((1 - blend) * cloth.previous.row(p) + blend * cloth.x.row(p)).transpose();
        };
        for (std::size_t k = 0; k < 2; ++k) {
            const auto [di, dj] = spring_directions[k];
            SpringStencil{di, dj, {}, 0}.for_each(cloth.model.grid, [&](int a, int b) {
                compared_.push_back({at(a), at(b)});
            });
        }
    }
}

void Marks::collect_bounds(const FrameView& view) {
    const ShownLevel shown = shown_level(view);
    for (const ClothView& cloth : view.cloths) {
        const BroadPhase& hierarchy = *cloth.hierarchy;
        touched_.take(cloth, *view.report);
        if (!shown.all && hierarchy.levels() > 0) {
            hierarchy.nodes_at(std::min(shown.level, hierarchy.levels() - 1), nodes_);
            append_nodes(nodes_, hierarchy.slack(), touched_, bounds_);
        }
        for (int level = 0; shown.all && level < hierarchy.levels(); ++level) {
            nodes_of_level(hierarchy, level, nodes_);
            append_nodes(nodes_, hierarchy.slack(), touched_, bounds_);
        }
    }
}

void Marks::arrange(const FrameView& view, const StreamBuffer& stream) {
    for (const StreamArray* array : {&springs_, &contacts_, &spheres_, &edges_}) array->follow(stream);
    if (!view.cloths.empty()) {
        const ClothModel& model = view.cloths.front().model;
        spacing_ = static_cast<float>(std::min(model.hx, model.hy));
    }
    if (show_particles_) index_springs(view);
}

void Marks::index_springs(const FrameView& view) {
    if (!update_grids(view, grids_)) return;

    SpringIndices springs = spring_indices(grids_);
    structural_count_ = static_cast<int>(springs.structural.size() / 2);
    shear_count_ = static_cast<int>(springs.shear.size() / 2);
    bend_count_ = static_cast<int>(springs.bend.size() / 2);
    std::vector<std::uint32_t>& all = springs.structural;
    all.insert(all.end(), springs.shear.begin(), springs.shear.end());
    all.insert(all.end(), springs.bend.begin(), springs.bend.end());
    springs_.bind();
    fill_static(gl_, GL_ELEMENT_ARRAY_BUFFER, spring_indices_, all);
}

void Marks::fill(const FrameView& view, StreamBuffer& stream) const {
    if (contact_count_ > 0) {
        auto* mark = stream.data<ContactMark>(Region::Contacts);
        for (const ClothView& cloth : view.cloths) {
            for (const ContactRow& contact : cloth.contacts) {
                copy(contact.point(cloth.x), mark->point);
                copy(contact.normal, mark->normal);
                ++mark;
            }
        }
    }
    auto* sphere_mark = stream.data<SphereMark>(Region::Spheres);
    const auto add_sphere = [&sphere_mark](const Vec3& centre, Real radius, float state) {
        copy(centre, sphere_mark->centre);
        sphere_mark->radius = static_cast<float>(radius);
        sphere_mark->state = state;
        ++sphere_mark;
    };
    for (const Outlines::Sphere& sphere : bounds_.spheres) {
        add_sphere(sphere.centre, sphere.radius, static_cast<float>(sphere.state));
    }
    const auto past_nodes = static_cast<float>(node_looks().size());  // the colour of the other simulation
    for (const BoundingSphere& ball : compared_balls_) add_sphere(ball.centre, ball.radius, past_nodes);
    auto* edge_mark = stream.data<EdgeMark>(Region::Edges);
    const auto add_edge = [&edge_mark](const Vec3& from, const Vec3& to, float state) {
        for (const Vec3* end : {&from, &to}) {
            copy(*end, edge_mark->point);
            edge_mark->state = state;
            ++edge_mark;
        }
    };
    for (const Outlines::Edge& edge : bounds_.edges) add_edge(edge.from, edge.to, static_cast<float>(edge.state));
    for (const auto& [from, to] : compared_) add_edge(from, to, past_nodes);
}

void Marks::add_to(PictureBounds& bounds) const {
    const auto add = [&bounds](const Vec3& point) { bounds.add(point.cast<float>().eval()); };
    for (const Outlines::Sphere& sphere : bounds_.spheres) {
        bounds.add(sphere.centre.cast<float>(), static_cast<float>(sphere.radius));
    }
    for (const BoundingSphere& ball : compared_balls_) {
        bounds.add(ball.centre.cast<float>(), static_cast<float>(ball.radius));
    }
    for (const Outlines::Edge& edge : bounds_.edges) add(edge.from), add(edge.to);
    for (const auto& [from, to] : compared_) add(from), add(to);
}

void Marks::draw() {
    if (show_particles_) {
        const int plain = structural_count_ + shear_count_;
        spring_program_.use();
        springs_.bind();
        gl_(glVertexAttrib1f, 4u, 0.0f);
        gl_.draw_elements(GL_LINES, 2 * plain);
        gl_(glVertexAttrib1f, 4u, bend_lift * spacing_);
        gl_.draw_elements(GL_LINES, 2 * bend_count_, 2 * static_cast<std::size_t>(plain) * sizeof(std::uint32_t));
        particle_program_.use();
        gl_.draw_arrays(GL_POINTS, particle_count_);
    }
    if (show_pins_) {
        pin_program_.use();
        springs_.bind();
        gl_.draw_arrays(GL_POINTS, particle_count_);
    }
    if (contact_count_ > 0) {
        contact_program_.use();
        contacts_.bind();
        gl_.draw_arrays_instanced(GL_TRIANGLES, contact_vertices, contact_count_);
    }
    if (sphere_count() > 0) {
        sphere_program_.use();
        spheres_.bind();
        draw_seen_and_hidden([this] {
            gl_.draw_arrays_instanced(GL_LINES, 2 * circles_per_sphere * segments(), static_cast<int>(sphere_count()));
        });
    }
    if (edge_count() > 0) {
        edge_program_.use();
        edges_.bind();
        draw_seen_and_hidden([this] { gl_.draw_arrays(GL_LINES, 2 * static_cast<int>(edge_count())); });
    }
}

template <class Draw>
void Marks::draw_seen_and_hidden(Draw draw) {
    draw();
    gl_(glVertexAttrib1f, hidden_attribute, 1.0f);
    gl_(glDepthFunc, GLenum{GL_GREATER});
    draw();
    gl_(glDepthFunc, GLenum{GL_LEQUAL});
    gl_(glVertexAttrib1f, hidden_attribute, 0.0f);
}

}  // namespace drape
