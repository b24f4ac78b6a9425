#pragma once

#include "gl_objects.h"
#include "program.h"

namespace drape {

/// The ground and the studio that it fades into, behind everything that was drawn before.
class Backdrop {
public:
    explicit Backdrop(Gl& gl) : gl_(gl), program_(gl, "backdrop"), no_vertices_(gl) {}

    void draw() {
        program_.use();
        gl_(glBindVertexArray, no_vertices_.name());
        gl_.draw_arrays(GL_TRIANGLES, 9);
    }

private:
    Gl& gl_;
    Program program_;
    VertexArray no_vertices_;  ///< core profile wants one, even where the shader makes the corners
};

}  // namespace drape
