#include "picture_target.h"

#include <algorithm>
#include <string>

#include "drape/base/input_error.h"

namespace drape {

namespace {

constexpr int wanted_samples = 4;

void attach(Gl& gl, const Renderbuffer& buffer, GLenum attachment) {
    gl(glFramebufferRenderbuffer, GLenum{GL_FRAMEBUFFER}, attachment, GLenum{GL_RENDERBUFFER}, buffer.name());
}

void check_complete(Gl& gl, int width, int height) {
    if (gl(glCheckFramebufferStatus, GLenum{GL_FRAMEBUFFER}) != GL_FRAMEBUFFER_COMPLETE) {
        throw RunError("OpenGL refuses a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                       " pixels");
    }
}

}  // namespace

PictureTarget::PictureTarget(Gl& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      colour_(gl),
      depth_(gl),
      resolved_colour_(gl),
      samples_(gl),
      resolved_(gl) {
    GLint most = 0;
    gl(glGetIntegerv, GLenum{GL_MAX_SAMPLES}, &most);
    const int count = std::min(wanted_samples, static_cast<int>(most));

    // Colour and depth with samples
    gl(glBindRenderbuffer, GLenum{GL_RENDERBUFFER}, colour_.name());
    gl(glRenderbufferStorageMultisample, GLenum{GL_RENDERBUFFER}, count, GLenum{GL_RGBA8}, width, height);
    gl(glBindRenderbuffer, GLenum{GL_RENDERBUFFER}, depth_.name());
    gl(glRenderbufferStorageMultisample, GLenum{GL_RENDERBUFFER}, count, GLenum{GL_DEPTH_COMPONENT24}, width, height);
    gl(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, samples_.name());
    attach(gl, colour_, GL_COLOR_ATTACHMENT0);
    attach(gl, depth_, GL_DEPTH_ATTACHMENT);
    check_complete(gl, width, height);

    // Colour alone without
    gl(glBindRenderbuffer, GLenum{GL_RENDERBUFFER}, resolved_colour_.name());
    gl(glRenderbufferStorage, GLenum{GL_RENDERBUFFER}, GLenum{GL_RGBA8}, width, height);
    gl(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, resolved_.name());
    attach(gl, resolved_colour_, GL_COLOR_ATTACHMENT0);
    check_complete(gl, width, height);
}

void PictureTarget::begin() {
    gl_(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, samples_.name());
    gl_(glViewport, 0, 0, width_, height_);
    gl_(glClear, GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT});
}

void PictureTarget::resolve() {
    gl_(glBindFramebuffer, GLenum{GL_DRAW_FRAMEBUFFER}, resolved_.name());
    gl_(glBlitFramebuffer, 0, 0, width_, height_, 0, 0, width_, height_, GLbitfield{GL_COLOR_BUFFER_BIT},
        GLenum{GL_NEAREST});
}

void PictureTarget::present() {
    gl_(glBindFramebuffer, GLenum{GL_READ_FRAMEBUFFER}, resolved_.name());
    gl_(glBindFramebuffer, GLenum{GL_DRAW_FRAMEBUFFER}, 0u);
    gl_(glBlitFramebuffer, 0, 0, width_, height_, 0, 0, width_, height_, GLbitfield{GL_COLOR_BUFFER_BIT},
        GLenum{GL_NEAREST});
}

Image PictureTarget::read_back() {
    const auto row = static_cast<std::size_t>(width_) * 3;
    Image image{width_, height_, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height_))};
    gl_(glBindFramebuffer, GLenum{GL_READ_FRAMEBUFFER}, resolved_.name());
    gl_(glReadPixels, 0, 0, width_, height_, GLenum{GL_RGB}, GLenum{GL_UNSIGNED_BYTE},
        static_cast<void*>(image.rgb.data()));

    // OpenGL's first row is the lowest
    for (std::size_t low = 0, high = static_cast<std::size_t>(height_) - 1; low < high; ++low, --high) {
        std::swap_ranges(&image.rgb[low * row], &image.rgb[low * row] + row, &image.rgb[high * row]);
    }
    return image;
}

}  // namespace drape
