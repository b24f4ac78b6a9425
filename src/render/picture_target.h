#pragma once

#include <memory>

#include "drape/render/image.h"
#include "gl_objects.h"

namespace drape {

/// The multisampled framebuffer that a frame is drawn into, and the plain one that it is resolved to.
class PictureTarget {
public:
    /// @throws RunError if OpenGL refuses the size
    PictureTarget(Gl& gl, int width, int height);

    /// Starts a picture: everything that follows is drawn multisampled.
    void begin();

    /// Averages the samples; what follows is drawn on top, not multisampled and without depth.
    void resolve();

    /// Copies the resolved picture to framebuffer 0, and leaves that bound.
    void present();

    [[nodiscard]] Image read_back();

private:
    Gl& gl_;
    int width_, height_;
    Renderbuffer colour_, depth_, resolved_colour_;
    Framebuffer samples_, resolved_;
};

}  // namespace drape
