#include "picture_target.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
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

PictureBox grown(const PictureBox& box, int room, int width, int height) {
    const int left = std::max(box.left - room, 0), low = std::max(box.low - room, 0);
    const int right = std::min(box.left + box.width + room, width);
    return {left, low, right - left, std::min(box.low + box.height + room, height) - low};
}

void PictureBounds::add(const Eigen::Vector3f& point) {
    constexpr float nearest = 1e-3f;  // m before the eye
    const Eigen::Vector4f clip = matrix_ * point.homogeneous();
    if (!(clip.w() > nearest)) {
        box_.extend(Eigen::Vector2f(-1, -1)).extend(Eigen::Vector2f(1, 1));
    } else {
        box_.extend(Eigen::Vector2f(clip.head<2>() / clip.w()));
    }
}

void PictureBounds::add(const Eigen::Vector3f& centre, float radius) {
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3f side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        add(centre + radius * side);
    }
}

PictureBox PictureBounds::box() const {
    if (box_.isEmpty()) return {};
    const auto edge = [](float coordinate, int size, int room) {
        const float pixel = std::floor((std::clamp(coordinate, -1.0f, 1.0f) * 0.5f + 0.5f) * static_cast<float>(size));
        return std::clamp(static_cast<int>(pixel) + room, 0, size);
    };
    const Eigen::Vector2f least = box_.min(), most = box_.max();
    const int left = edge(least.x(), width_, -1), low = edge(least.y(), height_, -1);
    return {left, low, edge(most.x(), width_, 2) - left, edge(most.y(), height_, 2) - low};
}

SampleBuffers::SampleBuffers(Gl& gl, int width, int height, int samples) : colour_(gl), depth_(gl), framebuffer_(gl) {
    GLint most = 0;
    gl(glGetIntegerv, GLenum{GL_MAX_SAMPLES}, &most);
    const int count = samples > 1 ? std::min(samples, static_cast<int>(most)) : 0;
    const auto store = [&](const Renderbuffer& buffer, GLenum format) {
        gl(glBindRenderbuffer, GLenum{GL_RENDERBUFFER}, buffer.name());
        gl(glRenderbufferStorageMultisample, GLenum{GL_RENDERBUFFER}, count, format, width, height);
    };
    store(colour_, GL_RGBA8);
    store(depth_, GL_DEPTH_COMPONENT24);
    gl(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, framebuffer_.name());
    attach(gl, colour_, GL_COLOR_ATTACHMENT0);
    attach(gl, depth_, GL_DEPTH_ATTACHMENT);
    check_complete(gl, width, height);
}

PictureTarget::PictureTarget(Gl& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      samples_(gl, width, height, wanted_samples),
      resolved_colour_(gl),
      resolved_(gl) {
    const GLenum target = GL_TEXTURE_2D;
    gl(glActiveTexture, GLenum{GL_TEXTURE2});
    gl(glBindTexture, target, resolved_colour_.name());
    gl(glTexImage2D, target, 0, GLint{GL_RGBA8}, width, height, 0, GLenum{GL_RGBA}, GLenum{GL_UNSIGNED_BYTE},
       static_cast<const void*>(nullptr));
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_MIN_FILTER}, GLint{GL_NEAREST});
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_MAG_FILTER}, GLint{GL_NEAREST});
    gl(glActiveTexture, GLenum{GL_TEXTURE0});
    gl(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, resolved_.name());
    gl(glFramebufferTexture2D, GLenum{GL_FRAMEBUFFER}, GLenum{GL_COLOR_ATTACHMENT0}, target, resolved_colour_.name(),
       0);
    check_complete(gl, width, height);
}

void PictureTarget::begin() {
    gl_(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, resolved_.name());
    gl_(glViewport, 0, 0, width_, height_);
}

void PictureTarget::begin_samples(const PictureBox& box, bool fast) {
    box_ = box;
    if (fast && !single_) single_.emplace(gl_, width_, height_, 1);
    const SampleBuffers& samples = fast ? *single_ : samples_;
    gl_(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, samples.framebuffer().name());
    gl_(glEnable, GLenum{GL_SCISSOR_TEST});
    gl_(glScissor, box.left, box.low, box.width, box.height);
    gl_(glClear, GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT});
}

void PictureTarget::resolve() {
    const int right = box_.left + box_.width, high = box_.low + box_.height;
    gl_(glDisable, GLenum{GL_SCISSOR_TEST});
    gl_(glBindFramebuffer, GLenum{GL_DRAW_FRAMEBUFFER}, resolved_.name());
    gl_(glBlitFramebuffer, box_.left, box_.low, right, high, box_.left, box_.low, right, high,
        GLbitfield{GL_COLOR_BUFFER_BIT}, GLenum{GL_NEAREST});
}

void PictureTarget::present() {
    gl_(glBindFramebuffer, GLenum{GL_READ_FRAMEBUFFER}, resolved_.name());
    gl_(glBindFramebuffer, GLenum{GL_DRAW_FRAMEBUFFER}, 0u);
    gl_(glBlitFramebuffer, 0, 0, width_, height_, 0, 0, width_, height_, GLbitfield{GL_COLOR_BUFFER_BIT},
        GLenum{GL_NEAREST});
}

Image PictureTarget::read_back() {
    // With four bytes a pixel, as it is stored, it is copied; with three it would be converted, at ten times the cost
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    std::vector<std::uint8_t> rgba(4 * pixels);
    gl_(glBindFramebuffer, GLenum{GL_READ_FRAMEBUFFER}, resolved_.name());
    gl_(glReadPixels, 0, 0, width_, height_, GLenum{GL_RGBA}, GLenum{GL_UNSIGNED_BYTE},
        static_cast<void*>(rgba.data()));

    // OpenGL's first row is the lowest
    Image image{width_, height_, std::vector<std::uint8_t>(3 * pixels)};
    std::uint8_t* to = image.rgb.data();
    for (int y = height_ - 1; y >= 0; --y) {
        const std::uint8_t* from = &rgba[4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)];
        for (int x = 0; x < width_; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
    }
    return image;
}

}  // namespace drape
