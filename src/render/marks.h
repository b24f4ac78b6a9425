#pragma once

#include <array>
#include <span>
#include <vector>

#include "drape/sim/frame_view.h"
#include "gl.h"
#include "outlines.h"
#include "picture_target.h"
#include "stream_buffer.h"

namespace drape {

struct FrameData;

/// What explains the picture: pins and what the hand holds; as far as the settings ask for them, particles and springs,
/// contacts, bounds; a ring about the particle that has diverged first, a thick line along the worst of its
/// springs, and one along the unstable mode's.
class Marks {
public:
    Marks(Gl& gl, StreamBuffer& stream);

    /// Collects what will be drawn.
    /// @param crosses lines that are drawn with those of the bounding volumes
    void fill(const FrameView& view, std::span<const Outlines::Edge> crosses, StreamBuffer& stream);

    /// Adds bounds, and what is compared; the rest is at solids, or anywhere.
    void add_to(PictureBounds& bounds) const;

    /// Over the solids, and last of all that has a depth; blending is on.
    /// @param failed whether the run has diverged at a particle, which is marked over all that is before it
    void draw(bool failed);

    /// How far marks stand out of the box of what is drawn [pixel].
    [[nodiscard]] int room(const FrameData& data) const;

    /// Adds the numbers of springs and of the segments of circles, and the particles' spacing.
    void add_to(FrameData& data) const;

private:
    [[nodiscard]] int segments() const;
    void collect_bounds(const FrameView& view);
    void collect_compared(const FrameView& view);
    void index_springs(const FrameView& view);
    void fill_contacts(const FrameView& view, StreamBuffer& stream) const;

    /// Fainter where something is before it. Nothing that asks for depths may be drawn afterwards.
    template <class Draw>
    void draw_seen_and_hidden(Draw draw);

    Gl& gl_;
    Program spring_program_, particle_program_, pin_program_, contact_program_, sphere_program_, edge_program_,
        failure_program_;
    StreamArray springs_, contacts_, spheres_, edges_;
    VertexArray no_vertices_;  ///< core profile wants one, even where the shader makes the corners
    Buffer spring_indices_;
    std::vector<Grid> grids_;
    Outlines bounds_;  ///< and structural springs and balls of the other simulation, and strains of cells
    ShownNodes nodes_;
    TouchedCells touched_;
    bool show_particles_ = false;
    bool show_pins_ = false;
    int particle_count_ = 0, contact_count_ = 0;
    std::array<int, 3> spring_counts_{};  ///< structural, shear, bend
    float spacing_ = 0;                   ///< of the particles of the first cloth [m]
};

}  // namespace drape
