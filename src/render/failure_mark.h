#pragma once

#include "frame_data.h"
#include "gl_objects.h"
#include "program.h"

namespace drape {

/// A ring about the particle that has diverged first, and a thick line along the worst of its springs, over all that is
/// before them.
class FailureMark {
public:
    explicit FailureMark(Gl& gl) : program_(gl, "failure"), no_vertices_(gl), gl_(gl) {}

    [[nodiscard]] static bool is_shown(const FrameData& data) { return data.failure[0].w() > 0; }

    /// Blending is on.
    void draw() {
        program_.use();
        gl_(glBindVertexArray, no_vertices_.name());
        gl_.draw_arrays(GL_TRIANGLES, 12);
    }

private:
    Program program_;
    VertexArray no_vertices_;  ///< core profile wants one, even where the shader makes the corners
    Gl& gl_;
};

}  // namespace drape
