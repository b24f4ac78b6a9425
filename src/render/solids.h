#pragma once

#include <memory>
#include <vector>

#include "drape/sim/frame_view.h"
#include "gl_objects.h"
#include "picture_target.h"
#include "program.h"
#include "stream_buffer.h"

namespace drape {

/// How the shaders get a `ClothVertex`.
VertexLayout cloth_layout();

/// The cloths, the balls and the solids: what is seen and what casts shadows.
class Solids {
public:
    Solids(Gl& gl, StreamBuffer& stream);

    void need(const FrameView& view, StreamBuffer& stream);

    /// Follows new grids, and regions of the stream that moved.
    void arrange(const FrameView& view, const StreamBuffer& stream);

    void fill(const FrameView& view, StreamBuffer& stream) const;

    /// Where the picture shows what was filled in.
    [[nodiscard]] PictureBox box(const Eigen::Matrix4f& view_projection, StreamBuffer& stream, int width,
                                 int height) const;

    /// Into the shadow map that is bound.
    void draw_shadow();

    /// @param wireframe draws the cloth's triangles as lines
    void draw(bool wireframe);

private:
    void draw_cloths();
    void draw_balls();
    void draw_bodies();
    bool update_bodies(const FrameView& view);

    Gl& gl_;
    Program cloth_program_, ball_program_, body_program_, depth_program_;
    StreamArray cloths_, balls_;
    Buffer cloth_indices_, sphere_vertices_, sphere_indices_;
    std::vector<Grid> grids_;
    std::vector<std::shared_ptr<const SolidShape>> shapes_;  ///< of the solids
    std::vector<TriangleMesh> meshes_;                       ///< of the shapes
    bool bodies_changed_ = false;
    std::size_t particle_count_ = 0, body_vertex_count_ = 0;
    int cloth_index_count_ = 0, body_index_count_ = 0, sphere_index_count_ = 0, ball_count_ = 0;
};

}  // namespace drape
