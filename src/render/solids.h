#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "cloth_mesh.h"
#include "drape/sim/frame_view.h"
#include "frame_data.h"
#include "gl.h"
#include "holders.h"
#include "picture_target.h"
#include "smooth_outline.h"
#include "stream_buffer.h"

namespace drape {

/// How the shaders get a `ClothVertex`.
inline VertexLayout cloth_layout() {
    return {sizeof(ClothVertex), {{0, 3}, {1, 3}, {2, 1}, {6, 1}, {7, 1}, {5, 4}, {9, 1}}};
}

/// The cloths, what they hang from, the balls and the solids: what is seen and what casts shadows.
/// In the buffer, the points of solids follow the particles, and the middles of edges follow those.
class Solids {
public:
    Solids(Gl& gl, StreamBuffer& stream)
        : gl_(gl),
          cloths_(gl, stream, Region::Cloth, cloth_layout()),
          outlined_(gl, stream, Region::Cloth, cloth_layout()),
          balls_(gl, stream, Region::Balls, {sizeof(DrawnBall), {{3, 4}, {4, 4}, {8, 1}}, true}),
          held_from_(gl, stream, Region::Holders, {sizeof(Holder), {{0, 4}, {1, 4}}, true}) {
        // The sphere is a grid that is rolled up
        const Grid rolled{sphere_columns + 1, sphere_rows + 1};
        const std::vector<std::uint32_t> indices = triangle_indices({&rolled, 1});
        sphere_index_count_ = static_cast<int>(indices.size());
        const VertexLayout points{sizeof(Eigen::Vector3f), {{0, 3}}};
        balls_.bind();
        fill_static(gl, GL_ELEMENT_ARRAY_BUFFER, sphere_indices_, indices);
        fill_static(gl, GL_ARRAY_BUFFER, sphere_vertices_, unit_sphere());
        points.set(gl, 0);

        outlined_.bind();
        stream.bind_indices();
        stream.bind_vertices();
    }

    /// Follows new grids and shapes, and finds what cloths hang from.
    void follow(const FrameView& view) {
        particle_count_ = 0;
        for (const ClothView& cloth : view.cloths)
            particle_count_ += static_cast<std::size_t>(cloth.model.grid.particles());
        ball_count_ = static_cast<int>(view.balls.size());
        hang(view, holders_);
        const bool has_other_bodies = update_kept(view.solids, shapes_, &Solid::shape);
        if (has_other_bodies) {
            meshes_.clear();
            body_vertex_count_ = 0;
            for (const Solid& solid : view.solids) {
                body_vertex_count_ += meshes_.emplace_back(solid.shape->surface()).points.size();
            }
        }

        // The colours of nodes are those of whole cells, and lines are drawn between particles
        const ViewSettings& shown = view.settings->view;
        smooth_ = shown.smooth && !shown.wireframe && shown.colour != ColourBy::Level &&
                  particle_count_ <= SmoothOutline::max_particles;
        if (update_kept(view.cloths, grids_, grid_of) || has_other_bodies) index_triangles();
    }

    /// @param values that colour the particles, if any do
    void fill(const FrameView& view, std::span<const float> values, const Viewpoint& from, StreamBuffer& stream) {
        const std::size_t middles = smooth_ ? SmoothOutline::middles_each * particle_count_ : 0;
        auto* vertex = stream.room<ClothVertex>(Region::Cloth, fixed_vertices() + middles);
        for (int number = 0; const ClothView& cloth : view.cloths) {
            fill_cloth_vertices(cloth, number++, view.blend, vertex);
            vertex += cloth.model.grid.particles();
        }
        auto* const particles = stream.data<ClothVertex>(Region::Cloth);
        for (std::size_t p = 0; p < values.size(); ++p) particles[p].value = values[p];
        for (std::size_t i = 0; i < view.solids.size(); ++i) {
            const TriangleMesh& mesh = meshes_[i];
            const Eigen::Quaternionf orientation = view.solids[i].orientation.cast<float>();
            const Eigen::Vector3f position = drawn_solid(view, i);
            for (std::size_t p = 0; p < mesh.points.size(); ++p, ++vertex) {
                const Eigen::Vector3f own = mesh.points[p].cast<float>();
                vertex->position = position + orientation * own;
                vertex->normal = orientation * mesh.normals[p].cast<float>();
                vertex->pinned = vertex->value = vertex->hollow = 0;
                vertex->place = {own.x(), own.y(), own.z(), 0};
                vertex->number = static_cast<float>(view.settings->solids[i].shape);
            }
        }
        fill_outlines(view, from, stream);
        std::ranges::copy(holders_, stream.room<Holder>(Region::Holders, holders_.size()));
        auto* balls = stream.room<DrawnBall>(Region::Balls, view.balls.size());
        for (std::size_t i = 0; i < view.balls.size(); ++i) {
            const float steered = static_cast<int>(i) == view.steered_ball ? 1 : 0;
            balls[i] = {drawn_ball(view, i), drawn_orientation(view, i), steered};
        }
    }

    /// Adds what was filled in.
    void add_to(PictureBounds& bounds, StreamBuffer& stream) const {
        for (const ClothVertex& vertex : std::span(stream.data<ClothVertex>(Region::Cloth), fixed_vertices())) {
            bounds.add(vertex.position);
        }
        for (const DrawnBall& ball :
             std::span(stream.data<DrawnBall>(Region::Balls), static_cast<std::size_t>(ball_count_))) {
            bounds.add(ball.sphere.head<3>(), ball.sphere.w());
        }
        for (const Holder& holder : holders_) {
            bounds.add(holder.from, holder.radius + holder.ring);
            if (holder.ring == 0) bounds.add(holder.to, holder.radius);
        }
    }

    [[nodiscard]] std::span<const Holder> holders() const { return holders_; }

    /// How far the cloth's outline stands out of what was added [pixel].
    [[nodiscard]] int room() const { return static_cast<int>(std::ceil(std::min(outline_room_, 1e4f))); }

    /// Into the shadow map that is bound.
    void draw_shadow() {
        depth_program_.use();
        draw_cloths();
        if (body_index_count_ > 0) draw_bodies();
        if (ball_count_ > 0) draw_balls();
        if (holders_.empty()) return;
        holder_depth_program_.use();
        draw_holders();
    }

    /// @param shown how the cloth is drawn: its triangles as lines, its colours
    /// @param line_width of other lines, which is left as it is [pixel]
    void draw(const ViewSettings& shown, float line_width, const StreamBuffer& stream) {
        const bool wireframe = shown.wireframe;
        shown.colour == ColourBy::Plain ? cloth_program_.use() : value_program_.use();
        if (wireframe) gl_(glPolygonMode, GL_FRONT_AND_BACK, GL_LINE);
        if (smooth_) {
            outlined_.bind();
            gl_.draw_elements(GL_TRIANGLES, outlined_index_count_, stream.start(Region::ClothIndices));
            gl_(glLineWidth, hem_width_);
            gl_.draw_elements(GL_LINES, hem_index_count_, stream.start(Region::ClothIndices) + hem_start_);
            gl_(glLineWidth, line_width);
        } else {
            draw_cloths();
        }
        if (wireframe) gl_(glPolygonMode, GL_FRONT_AND_BACK, GL_FILL);
        if (body_index_count_ > 0) {
            body_program_.use();
            draw_bodies();
        }
        if (ball_count_ > 0) {
            ball_program_.use();
            // Balls are closed, and half of their triangles face away
            gl_(glEnable, GL_CULL_FACE);
            draw_balls();
            gl_(glDisable, GL_CULL_FACE);
        }
        if (holders_.empty()) return;
        holder_program_.use();
        draw_holders();
    }

private:
    /// A ball as it is drawn.
    struct DrawnBall {
        Eigen::Vector4f sphere;       ///< centre, radius [m]
        Eigen::Vector4f orientation;  ///< x, y, z, w of a quaternion
        float steered;                ///< by the keys, as one of several: 1, else 0
    };

    // Fine enough that the outline of a ball that fills the picture is round: 0.1 % of the radius off
    static constexpr int sphere_rows = 36, sphere_columns = 72;

    static constexpr int holder_vertices = 2 * 7 * 12;  // as in the shader

    static std::vector<Eigen::Vector3f> unit_sphere() {
        std::vector<Eigen::Vector3f> points;
        for (int row = 0; row <= sphere_rows; ++row) {
            const float polar = std::numbers::pi_v<float> * static_cast<float>(row) / sphere_rows;
            for (int column = 0; column <= sphere_columns; ++column) {
                const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(column) / sphere_columns;
                points.emplace_back(std::sin(polar) * std::cos(turn), std::cos(polar),
                                    -std::sin(polar) * std::sin(turn));
            }
        }
        return points;
    }

    void index_triangles() {
        std::vector<std::uint32_t> indices = triangle_indices(grids_);
        cloth_index_count_ = static_cast<int>(indices.size());
        auto first = static_cast<std::uint32_t>(particle_count_);
        for (const TriangleMesh& mesh : meshes_) {
            for (const std::array<int, 3>& triangle : mesh.triangles) {
                for (const int corner : triangle) indices.push_back(first + static_cast<std::uint32_t>(corner));
            }
            first += static_cast<std::uint32_t>(mesh.points.size());
        }
        body_index_count_ = static_cast<int>(indices.size()) - cloth_index_count_;
        cloths_.bind();
        fill_static(gl_, GL_ELEMENT_ARRAY_BUFFER, cloth_indices_, indices);
    }

    void fill_outlines(const FrameView& view, const Viewpoint& from, StreamBuffer& stream) {
        const std::size_t room = smooth_ ? 24 * particle_count_ : 0;
        auto* const indices = stream.room<std::uint32_t>(Region::ClothIndices, room);
        auto* const vertices = stream.data<ClothVertex>(Region::Cloth);
        outline_room_ = 0;
        if (!smooth_) return;
        const auto thickness = static_cast<float>(view.settings->contact.thickness);
        hem_width_ = 1;
        std::size_t first = 0;
        std::uint32_t *end = indices, *hem = indices + room;
        for (const ClothView& cloth : view.cloths) {
            const std::size_t first_middle = fixed_vertices() + SmoothOutline::middles_each * first;
            const SmoothOutline::Vertices of_cloth{vertices + first, vertices + first_middle,
                                                   static_cast<std::uint32_t>(first),
                                                   static_cast<std::uint32_t>(first_middle)};
            end = outline_.fill(cloth.model.grid, of_cloth, from, end);
            hem = outline_.fill_hem(cloth.model.grid, of_cloth, hem);
            const auto count = static_cast<std::size_t>(cloth.model.grid.particles());
            const Eigen::Vector3f& inside = vertices[first + count / 2].position;
            hem_width_ = std::max(hem_width_, thickness * from.pixels / (from.eye - inside).norm());
            outline_room_ = std::max(outline_room_, outline_.farthest() + hem_width_);
            first += count;
        }
        outlined_index_count_ = static_cast<int>(end - indices);
        hem_start_ = sizeof(std::uint32_t) * static_cast<std::size_t>(hem - indices);
        hem_index_count_ = static_cast<int>(indices + room - hem);
    }

    void draw_cloths() {
        cloths_.bind();
        gl_.draw_elements(GL_TRIANGLES, cloth_index_count_);
    }

    void draw_balls() {
        balls_.bind();
        gl_.draw_elements(GL_TRIANGLES, sphere_index_count_, 0, ball_count_);
    }

    // They are closed, and half of their triangles face away; their indices follow those of the cloths
    void draw_bodies() {
        const std::size_t start = sizeof(std::uint32_t) * static_cast<std::size_t>(cloth_index_count_);
        cloths_.bind();
        gl_(glEnable, GL_CULL_FACE);
        gl_.draw_elements(GL_TRIANGLES, body_index_count_, start);
        gl_(glDisable, GL_CULL_FACE);
    }

    void draw_holders() {
        held_from_.bind();
        gl_.draw_arrays(GL_TRIANGLE_STRIP, holder_vertices, static_cast<int>(holders_.size()));
    }

    [[nodiscard]] std::size_t fixed_vertices() const { return particle_count_ + body_vertex_count_; }

    Gl& gl_;
    Program cloth_program_{gl_, "cloth"}, value_program_{gl_, "cloth", "cloth_value"}, ball_program_{gl_, "ball"},
        body_program_{gl_, "solid"}, holder_program_{gl_, "holder"}, depth_program_{gl_, "depth"},
        holder_depth_program_{gl_, "holder_depth", "depth"};
    StreamArray cloths_, outlined_, balls_, held_from_;
    Buffer cloth_indices_{gl_}, sphere_vertices_{gl_}, sphere_indices_{gl_};
    std::vector<Holder> holders_;
    std::vector<Grid> grids_;
    std::vector<std::shared_ptr<const SolidShape>> shapes_;  ///< of the solids
    std::vector<TriangleMesh> meshes_;                       ///< of the shapes
    SmoothOutline outline_;
    bool smooth_ = false;
    int outlined_index_count_ = 0, hem_index_count_ = 0;
    std::size_t hem_start_ = 0;  ///< in the region of indices [byte]
    float hem_width_ = 1;        ///< as thick as the cloth is for its contacts [pixel]
    float outline_room_ = 0;     ///< how far the outline stands out of the triangles between particles [pixel]
    std::size_t particle_count_ = 0, body_vertex_count_ = 0;
    int cloth_index_count_ = 0, body_index_count_ = 0, sphere_index_count_ = 0, ball_count_ = 0;
};

}  // namespace drape
