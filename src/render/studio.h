#pragma once

#include <optional>

#include "frame_data.h"
#include "gl_objects.h"
#include "program.h"

namespace drape {

/// The ground and the wall behind it. What no shadow falls on is drawn once, for as long as camera and size stay as
/// they are.
class Studio {
public:
    explicit Studio(Gl& gl);

    /// Draws what no shadow falls on, unless that is the picture that it has.
    void follow(const FrameData& data);

    /// Copies it into the framebuffer that is bound for drawing.
    void copy();

    /// Darkens the ground by its shadows, into the framebuffer that is bound; the shadow map is drawn, and
    /// blending is on.
    void draw_shadows();

    /// Puts the picture of texture unit 2 behind and below what was drawn before, into the framebuffer that is bound.
    void draw_behind();

private:
    Gl& gl_;
    Program studio_program_, shadow_program_, behind_program_;
    VertexArray no_vertices_;  ///< core profile wants one, even where the shader makes the corners
    Renderbuffer colour_;
    Framebuffer framebuffer_;
    std::optional<FrameData> drawn_;
};

}  // namespace drape
