#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>

#include "cloth_mesh.h"
#include "drape/render/image.h"
#include "gl_objects.h"

namespace drape {

/// A rectangle of a picture, from its lower left corner [pixel].
struct PictureBox {
    int left = 0, low = 0, width = 0, height = 0;
};

/// With as much room on all sides as the picture of this size has, up to `room` [pixel].
PictureBox grown(const PictureBox& box, int room, int width, int height);

/// A ball as it is drawn.
struct DrawnBall {
    Eigen::Vector4f sphere;       ///< centre, radius [m]
    Eigen::Vector4f orientation;  ///< x, y, z, w of a quaternion
};

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

/// Samples of colour and depth, some for each pixel.
class SampleBuffers {
public:
    /// @param samples for each pixel, as far as OpenGL has them
    /// @throws RunError if OpenGL refuses the size
    SampleBuffers(Gl& gl, int width, int height, int samples);

    [[nodiscard]] const Framebuffer& framebuffer() const { return framebuffer_; }

private:
    Renderbuffer colour_, depth_;
    Framebuffer framebuffer_;
};

/// The plain framebuffer that has the picture, and that with samples for the box in which there are outlines.
/// The picture is also the texture of unit 2, to be read while the samples are drawn.
class PictureTarget {
public:
    /// @throws RunError if OpenGL refuses the size
    PictureTarget(Gl& gl, int width, int height);

    /// Starts a picture: what follows is drawn plainly and without depth.
    void begin();

    /// What follows is drawn into samples, from nothing, and into a box only.
    /// @param fast one sample for each pixel, at half the cost with llvmpipe
    /// @throws RunError if OpenGL refuses the size
    void begin_samples(const PictureBox& box, bool fast);

    /// Puts the averages of the samples into the picture; what follows is drawn plainly again.
    void resolve();

    /// Copies the resolved picture to framebuffer 0, and leaves that bound.
    void present();

    [[nodiscard]] Image read_back();

private:
    Gl& gl_;
    int width_, height_;
    PictureBox box_;
    SampleBuffers samples_;
    std::optional<SampleBuffers> single_;  ///< for fast pictures, once there is one
    Texture resolved_colour_;
    Framebuffer resolved_;
};

}  // namespace drape
