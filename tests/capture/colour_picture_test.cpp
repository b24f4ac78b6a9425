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
std::array<double, 3> hue(const std::array<double, 3>& srgb) {
    std::array<double, 3> linear;
    double sum = 1e-9;
    for (std::size_t k = 0; k < 3; ++k) sum += linear[k] = std::pow(srgb[k], 2.2);
    for (double& channel : linear) channel /= sum;
    return linear;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The value in [0, 1] whose colour is nearest.
double value_of(const std::uint8_t* pixel) {
    const std::array<double, 3> seen = hue({pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0});
    double best = 0, nearest = 1e9;
    for (int step = 0; step <= 200; ++step) {
        const double at = step / 200.0 * static_cast<double>(value_colours.size() - 1);
        const auto first = std::min(static_cast<std::size_t>(at), value_colours.size() - 2);
        const double part = at - static_cast<double>(first);
        std::array<double, 3> mixed;
        for (std::size_t k = 0; k < 3; ++k) {
            mixed[k] = (1 - part) * static_cast<double>(value_colours[first][k]) +
                       part * static_cast<double>(value_colours[first + 1][k]);
        }
        const double away = distance(hue(mixed), seen);
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
