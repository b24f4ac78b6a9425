#pragma once

#include <memory>

#include "drape/render/image.h"
#include "gl_objects.h"
#include "picture_box.h"

namespace drape {

/// The plain framebuffer that has the picture, and the multisampled one for the box in which there are outlines.
/// The picture is also the texture of unit 2, to be read while the multisampled framebuffer is drawn into.
class PictureTarget {
public:
    /// @throws RunError if OpenGL refuses the size
    PictureTarget(Gl& gl, int width, int height);

    /// Starts a picture: what follows is drawn plainly and without depth.
    void begin();

    /// What follows is drawn multisampled, from nothing, and into a box only.
    void begin_samples(const PictureBox& box);

    /// Puts the averages of the samples into the picture; what follows is drawn plainly again.
    void resolve();

    /// Copies the resolved picture to framebuffer 0, and leaves that bound.
    void present();

    [[nodiscard]] Image read_back();

private:
    Gl& gl_;
    int width_, height_;
    PictureBox box_;
    Renderbuffer colour_, depth_;
    Texture resolved_colour_;
    Framebuffer samples_, resolved_;
};

}  // namespace drape
