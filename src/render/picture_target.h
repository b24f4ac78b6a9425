#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "drape/base/input_error.h"
#include "drape/render/image.h"
#include "gl.h"

namespace drape {

/// A rectangle of a picture, from its lower left corner [pixel].
struct PictureBox {
    int left = 0, low = 0, width = 0, height = 0;
};

/// The box around all that is drawn; the whole picture if something is beside or behind the eye.
class PictureBounds {
public:
    /// @param view_projection from the world to the picture, whose corners are (-1, -1) and (1, 1)
    PictureBounds(const Eigen::Matrix4f& view_projection, int width, int height)
        : matrix_(view_projection), width_(width), height_(height) {}

    void add(const Eigen::Vector3f& point) {
        constexpr float nearest = 1e-3f;  // m before the eye
        const Eigen::Vector4f clip = matrix_ * point.homogeneous();
        if (!(clip.w() > nearest)) {
            box_.extend(Eigen::Vector2f(-1, -1)).extend(Eigen::Vector2f(1, 1));
        } else {
            box_.extend(Eigen::Vector2f(clip.head<2>() / clip.w()));
        }
    }

    void add(const Eigen::Vector3f& centre, float radius) {
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3f side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            add(centre + radius * side);
        }
    }

    /// Whole pixels, and one around them for what is smoothed; empty if nothing was added.
    /// @param room more of them around it, as far as the picture has them
    [[nodiscard]] PictureBox box(int room = 0) const {
        if (box_.isEmpty()) return {};
        const auto edge = [](float coordinate, int size, int aside) {
            const float pixel =
                std::floor((std::clamp(coordinate, -1.0f, 1.0f) * 0.5f + 0.5f) * static_cast<float>(size));
            return std::clamp(static_cast<int>(pixel) + aside, 0, size);
        };
        const Eigen::Vector2f least = box_.min(), most = box_.max();
        const int left = edge(least.x(), width_, -1 - room), low = edge(least.y(), height_, -1 - room);
        return {left, low, edge(most.x(), width_, 2 + room) - left, edge(most.y(), height_, 2 + room) - low};
    }

private:
    Eigen::Matrix4f matrix_;
    Eigen::AlignedBox2f box_;
    int width_, height_;
};

/// A plain framebuffer of a size, and one with samples for the box in which there are outlines. The plain one is also a
/// texture, to be read while the samples are drawn.
struct PictureLayer {
    /// Leaves its texture bound to unit 2.
    /// @throws RunError if OpenGL refuses the size
    PictureLayer(Gl& gl, const PictureSize& picture)
        : size(picture), colour(gl), sample_colour(gl), sample_depth(gl), plain(gl), samples(gl) {
        const auto attach = [&gl](const Renderbuffer& buffer, GLenum attachment) {
            gl(glFramebufferRenderbuffer, GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
        };
        GLint most = 0;
        gl(glGetIntegerv, GL_MAX_SAMPLES, &most);
        const GLint count = std::min(wanted_samples, most);
        const auto store = [&](const Renderbuffer& buffer, GLenum format) {
            gl(glBindRenderbuffer, GL_RENDERBUFFER, buffer.name());
            gl(glRenderbufferStorageMultisample, GL_RENDERBUFFER, count, format, size.width, size.height);
        };
        store(sample_colour, GL_RGBA8);
        store(sample_depth, GL_DEPTH_COMPONENT24);
        gl(glBindFramebuffer, GL_FRAMEBUFFER, samples.name());
        attach(sample_colour, GL_COLOR_ATTACHMENT0);
        attach(sample_depth, GL_DEPTH_ATTACHMENT);
        check_complete(gl, size);

        const GLenum target = GL_TEXTURE_2D;
        gl(glActiveTexture, GL_TEXTURE2);
        gl(glBindTexture, target, colour.name());
        gl(glTexImage2D, target, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl(glTexParameteri, target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl(glTexParameteri, target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl(glActiveTexture, GL_TEXTURE0);
        gl(glBindFramebuffer, GL_FRAMEBUFFER, plain.name());
        gl(glFramebufferTexture2D, GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, colour.name(), 0);
        check_complete(gl, size);
    }

    static void check_complete(Gl& gl, const PictureSize& size) {
        if (gl(glCheckFramebufferStatus, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
        throw RunError("OpenGL refuses a picture of " + size_text(size) + " pixels");
    }

    static constexpr GLint wanted_samples = 4;  // for each pixel, as far as OpenGL has them

    const PictureSize size;
    Texture colour;
    Renderbuffer sample_colour, sample_depth;
    Framebuffer plain, samples;
};

/// The picture, and what the scene is drawn into: the picture itself, or for fast pictures a layer of half its width
/// and height, at half to two thirds of the cost with llvmpipe.
class PictureTarget {
public:
    /// @throws RunError if OpenGL refuses the size
    PictureTarget(Gl& gl, const PictureSize& size) : gl_(gl), full_(gl, size), layer_(&full_) {}

    /// How large the scene is drawn, of a picture that is drawn in full or fast.
    [[nodiscard]] PictureSize drawn_size(bool fast) const {
        const PictureSize& size = full_.size;
        return fast ? PictureSize{(size.width + 1) / 2, (size.height + 1) / 2} : size;
    }

    /// Starts a picture: what follows is drawn plainly and without depth.
    /// @throws RunError if OpenGL refuses the size
    void begin(bool fast) {
        if (fast && !half_) half_.emplace(gl_, drawn_size(fast));
        const PictureLayer* const wanted = fast ? &*half_ : &full_;
        if (wanted != layer_) {
            layer_ = wanted;
            gl_(glActiveTexture, GL_TEXTURE2);
            gl_(glBindTexture, GL_TEXTURE_2D, layer_->colour.name());
            gl_(glActiveTexture, GL_TEXTURE0);
        }
        gl_(glBindFramebuffer, GL_FRAMEBUFFER, layer_->plain.name());
        gl_(glViewport, 0, 0, layer_->size.width, layer_->size.height);
    }

    /// What follows is drawn into samples, from nothing, and into a box only. What was drawn plainly is the texture of
    /// unit 2.
    void begin_samples(const PictureBox& box) {
        box_ = box;
        gl_(glBindFramebuffer, GL_FRAMEBUFFER, layer_->samples.name());
        gl_(glEnable, GL_SCISSOR_TEST);
        gl_(glScissor, box.left, box.low, box.width, box.height);
        gl_(glClear, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    /// Puts the averages of the samples into the picture, magnified if the layer is smaller; what follows is drawn
    /// plainly, over the whole picture.
    void resolve() {
        const int right = box_.left + box_.width, high = box_.low + box_.height;
        gl_(glDisable, GL_SCISSOR_TEST);
        gl_(glBindFramebuffer, GL_DRAW_FRAMEBUFFER, layer_->plain.name());
        gl_(glBlitFramebuffer, box_.left, box_.low, right, high, box_.left, box_.low, right, high, GL_COLOR_BUFFER_BIT,
            GL_NEAREST);
        if (layer_ == &full_) return;
        const auto [width, height] = full_.size;
        gl_(glBindFramebuffer, GL_READ_FRAMEBUFFER, layer_->plain.name());
        gl_(glBindFramebuffer, GL_DRAW_FRAMEBUFFER, full_.plain.name());
        gl_(glBlitFramebuffer, 0, 0, layer_->size.width, layer_->size.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
            GL_LINEAR);
        gl_(glViewport, 0, 0, width, height);
    }

    /// Copies the picture to framebuffer 0, and leaves that bound.
    /// @param mark side of a red square at the upper right; 0: none [pixel]
    void present(int mark) {
        const auto [width, height] = full_.size;
        gl_(glBindFramebuffer, GL_READ_FRAMEBUFFER, full_.plain.name());
        gl_(glBindFramebuffer, GL_DRAW_FRAMEBUFFER, 0);
        gl_(glBlitFramebuffer, 0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        if (mark == 0) return;
        gl_(glEnable, GL_SCISSOR_TEST);
        gl_(glScissor, width - 2 * mark, height - 2 * mark, mark, mark);
        constexpr float red[] = {0.9f, 0.1f, 0.1f, 1};
        gl_(glClearBufferfv, GL_COLOR, 0, red);
        gl_(glDisable, GL_SCISSOR_TEST);
    }

    [[nodiscard]] Image read_back() {
        // With four bytes a pixel, as it is stored, it is copied; with three it would be converted, at ten times the
        // cost
        const auto [width, height] = full_.size;
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        std::vector<std::uint8_t> rgba(4 * pixels);
        gl_(glBindFramebuffer, GL_READ_FRAMEBUFFER, full_.plain.name());
        gl_(glReadPixels, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());

        // OpenGL's first row is the lowest
        Image image{width, height, std::vector<std::uint8_t>(3 * pixels)};
        std::uint8_t* to = image.rgb.data();
        for (int y = height - 1; y >= 0; --y) {
            const std::uint8_t* from = &rgba[4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
            for (int x = 0; x < width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
        }
        return image;
    }

private:
    Gl& gl_;
    PictureBox box_;
    PictureLayer full_;
    std::optional<PictureLayer> half_;  ///< once a picture was drawn fast
    const PictureLayer* layer_;         ///< into which the scene is drawn
};

}  // namespace drape
