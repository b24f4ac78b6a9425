#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "cloth_colours.h"
#include "drape/sim/frame_view.h"
#include "gl.h"
#include "holders.h"
#include "picture_target.h"
#include "smooth_outline.h"
#include "stream_buffer.h"

namespace drape {

/// How the shaders get a `ClothVertex`.
VertexLayout cloth_layout();

/// The cloths, what they hang from, the balls and the solids: what is seen and what casts shadows.
/// In the buffer, the points of solids follow the particles, and the middles of edges follow those.
class Solids {
public:
    Solids(Gl& gl, StreamBuffer& stream);

    /// Follows new grids and shapes, and finds what cloths hang from.
    void follow(const FrameView& view, StreamBuffer& stream);

    void fill(const FrameView& view, const ClothColours& colours, const Viewpoint& from, StreamBuffer& stream);

    /// Adds what was filled in.
    void add_to(PictureBounds& bounds, StreamBuffer& stream) const;

    [[nodiscard]] std::span<const Holder> holders() const { return holders_; }

    /// How far the cloth's outline stands out of what was added [pixel].
    [[nodiscard]] int room() const { return static_cast<int>(std::ceil(std::min(outline_room_, 1e4f))); }

    /// Into the shadow map that is bound.
    void draw_shadow();

    /// @param shown how the cloth is drawn: its triangles as lines, its colours
    void draw(const ViewSettings& shown, const StreamBuffer& stream);

private:
    void draw_cloths();
    void draw_balls();
    void draw_bodies();
    void draw_holders();
    bool update_bodies(const FrameView& view);
    void fill_places(const FrameView& view, StreamBuffer& stream);
    void index_triangles();
    void fill_outlines(const FrameView& view, const Viewpoint& from, StreamBuffer& stream);
    void draw_indices(int first, int count);
    [[nodiscard]] std::size_t fixed_vertices() const { return particle_count_ + body_vertex_count_; }

    Gl& gl_;
    Program cloth_program_, value_program_, ball_program_, body_program_, holder_program_, depth_program_,
        holder_depth_program_;
    StreamArray cloths_, outlined_, balls_, held_from_;
    Buffer cloth_indices_, cloth_places_, sphere_vertices_, sphere_indices_;
    std::vector<Holder> holders_;
    std::vector<Grid> grids_;
    std::vector<std::array<Real, 2>> spacings_;              ///< of the grids [m]
    std::vector<std::shared_ptr<const SolidShape>> shapes_;  ///< of the solids
    std::vector<TriangleMesh> meshes_;                       ///< of the shapes
    SmoothOutline outline_;
    bool smooth_ = false;
    bool coarse_ = false;  ///< rows and columns of particles are left out
    int outlined_index_count_ = 0;
    float outline_room_ = 0;  ///< how far the outline stands out of the triangles between particles [pixel]
    std::size_t particle_count_ = 0, body_vertex_count_ = 0;
    int cloth_index_count_ = 0, coarse_index_count_ = 0, body_index_count_ = 0, sphere_index_count_ = 0,
        ball_count_ = 0;
};

}  // namespace drape
