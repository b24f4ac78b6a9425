#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "drape/render/image.h"
#include "gl.h"

namespace drape {

/// A rectangle of a picture, from its lower left corner [pixel].
struct PictureBox {
    int left = 0, low = 0, width = 0, height = 0;
    bool operator==(const PictureBox&) const = default;
};

/// With as much room on all sides as the picture of this size has, up to `room` [pixel].
PictureBox grown(const PictureBox& box, int room, int width, int height);

/// The box around all that is drawn; the whole picture if something is beside or behind the eye.
class PictureBounds {
public:
    /// @param view_projection from the world to the picture, whose corners are (-1, -1) and (1, 1)
    PictureBounds(const Eigen::Matrix4f& view_projection, int width, int height)
        : matrix_(view_projection), width_(width), height_(height) {}

    void add(const Eigen::Vector3f& point);
    void add(const Eigen::Vector3f& centre, float radius);

    /// Whole pixels, and one around them for what is smoothed; empty if nothing was added.
    [[nodiscard]] PictureBox box() const;

private:
    Eigen::Matrix4f matrix_;
    Eigen::AlignedBox2f box_;
    int width_, height_;
};

/// A plain framebuffer of a size, and one with samples for the box in which there are outlines. The plain one is also a
/// texture, to be read while the samples are drawn.
struct PictureLayer {
    /// @param samples_wanted for each pixel, as far as OpenGL has them
    /// @throws RunError if OpenGL refuses the size
    PictureLayer(Gl& gl, const PictureSize& picture, int samples_wanted);

    const PictureSize size;
    Texture colour;
    Renderbuffer sample_colour, sample_depth;
    Framebuffer plain, samples;
};

/// The picture, and what the scene is drawn into: the picture itself, or for fast pictures a layer of half its width
/// and height with one sample for each pixel, at about a third of the cost with llvmpipe.
class PictureTarget {
public:
    /// @throws RunError if OpenGL refuses the size
    PictureTarget(Gl& gl, const PictureSize& size);

    /// How large the scene is drawn, of a picture that is drawn in full or fast.
    [[nodiscard]] PictureSize drawn_size(bool fast) const;

    /// Starts a picture: what follows is drawn plainly and without depth.
    /// @throws RunError if OpenGL refuses the size
    void begin(bool fast);

    /// What follows is drawn into samples, from nothing, and into a box only. What was drawn plainly is the texture of
    /// unit 2.
    void begin_samples(const PictureBox& box);

    /// Puts the averages of the samples into the picture, magnified if the layer is smaller; what follows is drawn
    /// plainly, over the whole picture.
    /// @param for_window whether what is magnified becomes a picture in framebuffer 0 at once, and has no other copy
    void resolve(bool for_window);

    /// Copies the picture to framebuffer 0, unless it is there, and leaves that bound.
    void present();

    /// @pre the picture was not drawn for a window
    [[nodiscard]] Image read_back();

private:
    Gl& gl_;
    PictureBox box_;
    PictureLayer full_;
    std::optional<PictureLayer> half_;  ///< once a picture was drawn fast
    const PictureLayer* layer_;         ///< into which the scene is drawn
    bool in_window_ = false;            ///< the picture is in framebuffer 0 and nowhere else
};

}  // namespace drape
