#pragma once

#include <vector>

#include "drape/sim/simulation.h"
#include "gl_objects.h"
#include "program.h"
#include "stream_buffer.h"

namespace drape {

/// Sets the attributes of `ClothVertex` in the vertex array that is bound.
void set_cloth_attributes(Gl& gl, StreamBuffer& stream);

/// The cloths and the balls: what is seen and what casts shadows.
class Solids {
public:
    explicit Solids(Gl& gl);

    void need(const FrameView& view, StreamBuffer& stream) const;

    /// Follows new grids, and new places in the stream.
    /// @param moved the stream's places have changed
    void arrange(const FrameView& view, StreamBuffer& stream, bool moved);

    void fill(const FrameView& view, StreamBuffer& stream) const;

    /// Into the shadow map that is bound.
    void draw_shadow();

    /// @param wireframe draws the cloth's triangles as lines
    void draw(bool wireframe);

private:
    void draw_cloths();
    void draw_balls();

    Gl& gl_;
    Program cloth_program_, ball_program_, depth_program_;
    VertexArray cloth_array_, ball_array_;
    Buffer cloth_indices_, sphere_vertices_, sphere_indices_;
    std::vector<Grid> grids_;
    int cloth_index_count_ = 0, sphere_index_count_ = 0, ball_count_ = 0;
};

}  // namespace drape
