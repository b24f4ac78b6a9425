// The cloth's colours in the picture are those that the values have in the legend.

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_scene.h"
#include "expected_picture.h"
#include "render/cloth_colours.h"

namespace drape::test {
namespace {

constexpr int picture_wide = 640, picture_high = 360;

/// Which part of the whole each channel has, in linear light: the same for a colour in any light that is white.
Eigen::Array3d hue(const Eigen::Array3d& srgb) {
    const Eigen::Array3d linear = srgb.pow(2.2);
    return linear / (linear.sum() + 1e-9);
}

/// The value in [0, 1] whose colour is nearest.
double value_of(const std::uint8_t* pixel) {
    const auto colour = [](std::size_t k) -> Eigen::Array3d {
        return Eigen::Array3f(value_colours[k].data()).cast<double>();
    };
    const Eigen::Array3d seen = hue(Eigen::Array3d(pixel[0], pixel[1], pixel[2]) / 255);
    double best = 0, nearest = 1e9;
    for (int step = 0; step <= 200; ++step) {
        const double at = step / 200.0 * static_cast<double>(value_colours.size() - 1);
        const auto first = std::min(static_cast<std::size_t>(at), value_colours.size() - 2);
        const double part = at - static_cast<double>(first);
        const Eigen::Array3d mixed = (1 - part) * colour(first) + part * colour(first + 1);
        const double away = (hue(mixed) - seen).matrix().norm();
        if (away < nearest) nearest = away, best = step / 200.0;
    }
    return best;
}

/// A cloth at rest whose speed grows evenly from 0 at its left side to `fastest` at its right.
struct ColourPicture : DrawnScene, testing::Test {
    ColourPicture() : DrawnScene("drop") { settings.view.colour = ColourBy::Speed; }

    Image draw_with_speeds(Real fastest) {
        const Grid& grid = cloth().model.grid;
        Points v = Points::Zero(grid.particles(), 3);
        for (int p = 0; p < grid.particles(); ++p) {
            v(p, 1) = fastest * static_cast<Real>(p % grid.nx) / static_cast<Real>(grid.nx - 1);
        }
        const ClothView moving{cloth().model, cloth().x, cloth().x, {}, cloth().hierarchy, &v};
        FrameView changed = view;
        changed.cloths = {&moving, 1};
        return picture_of(changed, picture_wide, picture_high);
    }

    /// How far the values in the picture are from what they must be, on average.
    [[nodiscard]] double error(const Image& image) const {
        const ExpectedPicture expected(view, picture_wide, picture_high);
        const Grid& grid = cloth().model.grid;
        double sum = 0;
        int count = 0;
        for (int p = 0; p < grid.particles(); ++p) {
            const auto place = expected.project(cloth().x.row(p).transpose());
            const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
            if (!expected.surely(Seen::Front, x, y, 2)) continue;
            const double wanted = 0.9 * (p % grid.nx) / (grid.nx - 1);
            sum += std::abs(value_of(image.pixel(x, y)) - wanted);
            ++count;
        }
        EXPECT_GT(count, 300);
        return sum / count;
    }
};

TEST_F(ColourPicture, ShowsTheValuesOfTheParticles) {
    EXPECT_LT(error(draw_with_speeds(Real(0.9))), 0.03);
    EXPECT_GT(error(draw_with_speeds(Real(0.8))), 0.04) << "values ten percent off";
    settings.view.colour = ColourBy::Plain;
    EXPECT_GT(error(draw_with_speeds(Real(0.9))), 0.2) << "no colours";
}

}  // namespace
}  // namespace drape::test
