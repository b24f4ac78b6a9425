#pragma once

#include <array>
#include <vector>

#include "drape/sim/frame_view.h"

namespace drape::test {

/// What a pixel must show.
enum class Seen : unsigned char { Nothing, Front, Back, Ball, Cord };

/// What a picture must show, from the state alone: projected and filled here, with nothing of the renderer's.
class ExpectedPicture {
public:
    ExpectedPicture(const FrameView& view, int width, int height);

    [[nodiscard]] Seen at(int x, int y) const { return seen_[index(x, y)]; }

    /// As `at`, and the same in all pixels up to `margin` away.
    [[nodiscard]] bool surely(Seen what, int x, int y, int margin) const;

    /// How far ahead of the eye what it shows is; infinite where nothing is [m].
    [[nodiscard]] double depth(int x, int y) const { return depth_[index(x, y)]; }

    [[nodiscard]] int count(Seen what) const;

    /// Where a point is in the picture [pixel], and how far ahead of the eye [m].
    struct Projected {
        double x, y, depth;
    };
    [[nodiscard]] Projected project(const Vec3& point) const;

    /// A point of a ball's outline that nothing hides: where it is in the picture, and the way out of the ball.
    struct OutlinePoint {
        double x, y;
        double out_x, out_y;
    };
    [[nodiscard]] std::vector<OutlinePoint> ball_outline(const FrameView& view, std::size_t ball) const;

    /// Whether light reaches the ground in a pixel.
    enum class Ground { Unclear, Lit, Shadowed };
    [[nodiscard]] Ground ground_at(const FrameView& view, int x, int y) const;

private:
    [[nodiscard]] Vec3 direction(double x, double y) const;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    void fill_cloth(const ClothView& cloth);
    void fill_ball(const Ball& ball);
    void fill_cord(const Vec3& pin);

    int width_, height_;
    Vec3 eye_, right_, up_, ahead_;
    double pixels_per_slope_;
    std::vector<Seen> seen_;
    std::vector<double> depth_;
};

}  // namespace drape::test
