#include "solids.h"

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "cloth_mesh.h"
#include "frame_data.h"

namespace drape {

namespace {

// Fine enough that the outline of a ball that fills the picture is round: 0.1 % of the radius off
constexpr int sphere_rows = 36, sphere_columns = 72;

std::vector<Eigen::Vector3f> unit_sphere() {
    std::vector<Eigen::Vector3f> points;
    for (int row = 0; row <= sphere_rows; ++row) {
        const float polar = std::numbers::pi_v<float> * static_cast<float>(row) / sphere_rows;
        for (int column = 0; column <= sphere_columns; ++column) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(column) / sphere_columns;
            points.emplace_back(std::sin(polar) * std::cos(turn), std::cos(polar), -std::sin(polar) * std::sin(turn));
        }
    }
    return points;
}

template <class T>
void fill_static(Gl& gl, GLenum target, const Buffer& buffer, const std::vector<T>& data) {
    gl(glBindBuffer, target, buffer.name());
    gl(glBufferData, target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), static_cast<const void*>(data.data()),
       GLenum{GL_STATIC_DRAW});
}

}  // namespace

void enable_cloth_attributes(Gl& gl) {
    for (GLuint location = 0; location < 3; ++location) enable_attribute(gl, location);
}

void place_cloth_attributes(Gl& gl, const StreamBuffer& stream) {
    const std::size_t start = stream.place(Region::Cloth), stride = sizeof(ClothVertex);
    place_attribute(gl, {0, 3, stride, start + offsetof(ClothVertex, position)});
    place_attribute(gl, {1, 3, stride, start + offsetof(ClothVertex, normal)});
    place_attribute(gl, {2, 1, stride, start + offsetof(ClothVertex, pinned)});
}

Solids::Solids(Gl& gl, StreamBuffer& stream)
    : gl_(gl),
      cloth_program_(gl, "cloth"),
      ball_program_(gl, "ball"),
      depth_program_(gl, "depth"),
      cloth_array_(gl),
      ball_array_(gl),
      cloth_indices_(gl),
      sphere_vertices_(gl),
      sphere_indices_(gl) {
    // The sphere is a grid that is rolled up
    std::vector<std::uint32_t> indices;
    append_triangle_indices({sphere_columns + 1, sphere_rows + 1}, 0, indices);
    sphere_index_count_ = static_cast<int>(indices.size());
    gl(glBindVertexArray, ball_array_.name());
    fill_static(gl, GL_ELEMENT_ARRAY_BUFFER, sphere_indices_, indices);
    fill_static(gl, GL_ARRAY_BUFFER, sphere_vertices_, unit_sphere());
    enable_attribute(gl, 0);
    place_attribute(gl, {0, 3, sizeof(Eigen::Vector3f), 0});
    stream.bind_vertices();
    enable_attribute(gl, 3, true);
    place_balls(stream);

    gl(glBindVertexArray, cloth_array_.name());
    enable_cloth_attributes(gl);
    place_cloths(stream);
}

void Solids::place_cloths(const StreamBuffer& stream) {
    gl_(glBindVertexArray, cloth_array_.name());
    place_cloth_attributes(gl_, stream);
}

void Solids::place_balls(const StreamBuffer& stream) {
    gl_(glBindVertexArray, ball_array_.name());
    place_attribute(gl_, {3, 4, sizeof(Eigen::Vector4f), stream.place(Region::Balls)});
}

void Solids::need(const FrameView& view, StreamBuffer& stream) {
    particle_count_ = 0;
    for (const ClothView& cloth : view.cloths)
        particle_count_ += static_cast<std::size_t>(cloth.model.grid.particles());
    stream.need(Region::Cloth, particle_count_ * sizeof(ClothVertex));
    stream.need(Region::Balls, view.balls.size() * sizeof(Eigen::Vector4f));
}

void Solids::arrange(const FrameView& view, const StreamBuffer& stream) {
    if (stream.moved(Region::Cloth)) place_cloths(stream);
    if (stream.moved(Region::Balls)) place_balls(stream);
    ball_count_ = static_cast<int>(view.balls.size());

    // New triangles where a grid is new
    bool same = grids_.size() == view.cloths.size();
    for (std::size_t i = 0; same && i < grids_.size(); ++i) same = grids_[i] == view.cloths[i].model.grid;
    if (same) return;
    grids_.clear();
    std::vector<std::uint32_t> indices;
    std::uint32_t first_vertex = 0;
    for (const ClothView& cloth : view.cloths) {
        grids_.push_back(cloth.model.grid);
        append_triangle_indices(cloth.model.grid, first_vertex, indices);
        first_vertex += static_cast<std::uint32_t>(cloth.model.grid.particles());
    }
    cloth_index_count_ = static_cast<int>(indices.size());
    gl_(glBindVertexArray, cloth_array_.name());
    fill_static(gl_, GL_ELEMENT_ARRAY_BUFFER, cloth_indices_, indices);
}

void Solids::fill(const FrameView& view, StreamBuffer& stream) const {
    auto* vertex = stream.data<ClothVertex>(Region::Cloth);
    for (const ClothView& cloth : view.cloths) {
        fill_cloth_vertices(cloth, view.blend, vertex);
        vertex += cloth.model.grid.particles();
    }
    auto* balls = stream.data<float>(Region::Balls);
    for (std::size_t i = 0; i < view.balls.size(); ++i) {
        Eigen::Map<Eigen::Vector4f>(balls + 4 * i) = drawn_ball(view, i);
    }
}

PictureBox Solids::box(const Eigen::Matrix4f& view_projection, StreamBuffer& stream, int width, int height) const {
    return solid_box(view_projection, {stream.data<ClothVertex>(Region::Cloth), particle_count_},
                     {stream.data<Eigen::Vector4f>(Region::Balls), static_cast<std::size_t>(ball_count_)}, width,
                     height);
}

void Solids::draw_cloths() {
    gl_(glBindVertexArray, cloth_array_.name());
    gl_.draw_elements(GL_TRIANGLES, cloth_index_count_);
}

void Solids::draw_balls() {
    gl_(glBindVertexArray, ball_array_.name());
    gl_.draw_elements_instanced(GL_TRIANGLES, sphere_index_count_, ball_count_);
}

void Solids::draw_shadow() {
    depth_program_.use();
    draw_cloths();
    if (ball_count_ > 0) draw_balls();
}

void Solids::draw(bool wireframe) {
    cloth_program_.use();
    if (wireframe) gl_(glPolygonMode, GLenum{GL_FRONT_AND_BACK}, GLenum{GL_LINE});
    draw_cloths();
    if (wireframe) gl_(glPolygonMode, GLenum{GL_FRONT_AND_BACK}, GLenum{GL_FILL});
    if (ball_count_ > 0) {
        ball_program_.use();
        // Balls are closed, and half of their triangles face away
        gl_(glEnable, GLenum{GL_CULL_FACE});
        draw_balls();
        gl_(glDisable, GLenum{GL_CULL_FACE});
    }
}

}  // namespace drape
