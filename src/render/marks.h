#pragma once

#include <array>
#include <vector>

#include "drape/sim/frame_view.h"
#include "gl_objects.h"
#include "outlines.h"
#include "picture_target.h"
#include "program.h"
#include "stream_buffer.h"

namespace drape {

/// What explains the picture: pins and what the hand holds; as far as the settings ask for them, particles and springs,
/// contacts, bounds.
class Marks {
public:
    Marks(Gl& gl, StreamBuffer& stream);

    /// Collects what will be drawn.
    void need(const FrameView& view, StreamBuffer& stream);

    /// Follows new grids, and regions of the stream that moved.
    void arrange(const FrameView& view, const StreamBuffer& stream);

    void fill(const FrameView& view, StreamBuffer& stream) const;

    /// Adds bounds, and what is compared; the rest is at solids, or anywhere.
    void add_to(PictureBounds& bounds) const;

    /// Over the solids, and last of all that has a depth; blending is on.
    void draw();

    /// How far marks stand out of the solids whose box is drawn [pixel].
    [[nodiscard]] int room() const { return show_pins_ ? 24 : 0; }

    [[nodiscard]] int structural_springs() const { return structural_count_; }
    [[nodiscard]] int shear_springs() const { return shear_count_; }
    [[nodiscard]] float spacing() const { return spacing_; }
    /// Of the circles of a bounding sphere: fewer where there are many spheres.
    [[nodiscard]] int segments() const;

private:
    void collect_bounds(const FrameView& view);
    void collect_compared(const FrameView& view);
    void index_springs(const FrameView& view);

    [[nodiscard]] std::size_t sphere_count() const { return bounds_.spheres.size() + compared_balls_.size(); }
    [[nodiscard]] std::size_t edge_count() const { return bounds_.edges.size() + compared_.size(); }

    /// Fainter where something is before it. Nothing that asks for depths may be drawn afterwards.
    template <class Draw>
    void draw_seen_and_hidden(Draw draw);

    Gl& gl_;
    Program spring_program_, particle_program_, pin_program_, contact_program_, sphere_program_, edge_program_;
    StreamArray springs_, contacts_, spheres_, edges_;
    Buffer spring_indices_;
    std::vector<Grid> grids_;
    Outlines bounds_;
    std::vector<std::array<Vec3, 2>> compared_;   ///< structural springs of the other simulation
    std::vector<BoundingSphere> compared_balls_;  ///< where they are elsewhere
    std::vector<NodeView> nodes_;
    TouchedCells touched_;
    bool show_particles_ = false;
    bool show_pins_ = false;
    int particle_count_ = 0, contact_count_ = 0;
    int structural_count_ = 0, shear_count_ = 0, bend_count_ = 0;
    float spacing_ = 0;  ///< of the particles of the first cloth [m]
};

}  // namespace drape
