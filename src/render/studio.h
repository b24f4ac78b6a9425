#pragma once

#include <optional>

#include "frame_data.h"
#include "gl.h"

namespace drape {

/// The ground and the wall behind it. What no shadow falls on is drawn once, for as long as camera and size stay as
/// they are.
class Studio {
public:
    explicit Studio(Gl& gl) : gl_(gl) {}

    /// Draws what no shadow falls on, unless that is the picture that it has.
    void follow(const FrameData& data) {
        if (drawn_ && same_studio(data, *drawn_)) return;
        gl_(glBindFramebuffer, GL_FRAMEBUFFER, framebuffer_.name());
        const int width = static_cast<int>(data.viewport[0]), height = static_cast<int>(data.viewport[1]);
        if (!drawn_ || data.viewport != drawn_->viewport) {
            gl_(glBindRenderbuffer, GL_RENDERBUFFER, colour_.name());
            gl_(glRenderbufferStorage, GL_RENDERBUFFER, GL_RGBA8, width, height);
            gl_(glFramebufferRenderbuffer, GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
        }
        gl_(glViewport, 0, 0, width, height);
        studio_program_.use();
        gl_(glBindVertexArray, no_vertices_.name());
        gl_.draw_arrays(GL_TRIANGLES, 3);
        drawn_ = data;
    }

    /// Copies it into the framebuffer that is bound for drawing.
    void copy() {
        gl_(glBindFramebuffer, GL_READ_FRAMEBUFFER, framebuffer_.name());
        const int width = static_cast<int>(drawn_->viewport[0]), height = static_cast<int>(drawn_->viewport[1]);
        gl_(glBlitFramebuffer, 0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

    /// Darkens the ground by its shadows, into the framebuffer that is bound; the shadow map is drawn, and
    /// blending is on.
    void draw_shadows() {
        shadow_program_.use();
        gl_(glBindVertexArray, no_vertices_.name());
        gl_.draw_arrays(GL_TRIANGLE_STRIP, 2 * (ground_cells + 1), ground_cells);
    }

    /// Puts the picture of texture unit 2 behind and below what was drawn before, into the framebuffer that is bound.
    void draw_behind() {
        behind_program_.use();
        gl_(glBindVertexArray, no_vertices_.name());
        gl_.draw_arrays(GL_TRIANGLES, 9);
    }

private:
    // Along each side of what the shadow map covers, as in the shader; at each corner it is found what is near above
    static constexpr int ground_cells = 40;

    // Whether two frames show the same studio, but for shadows
    static bool same_studio(const FrameData& a, const FrameData& b) {
        return a.view_projection == b.view_projection && a.eye == b.eye && a.viewport == b.viewport &&
               a.stage == b.stage && a.look[2] == b.look[2] && a.style == b.style;
    }

    Gl& gl_;
    Program studio_program_{gl_, "studio"}, shadow_program_{gl_, "ground_shadow"}, behind_program_{gl_, "backdrop"};
    VertexArray no_vertices_{gl_};  ///< core profile wants one, even where the shader makes the corners
    Renderbuffer colour_{gl_};
    Framebuffer framebuffer_{gl_};
    std::optional<FrameData> drawn_;
};

}  // namespace drape
