// The curves of the plots are where their values belong on the axes.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "drawn_scene.h"

namespace drape::test {
namespace {

constexpr int plots_width = 1280, plots_height = 720;

struct Ink {
    int red, green, blue;
};
constexpr Ink orange_ink{230, 159, 0}, sky_ink{86, 180, 233};

/// The second of five panels, that of the energy: where its two lines of the axis are, which are faint and go across.
struct EnergyAxis {
    int left = 0, right = 0, top = 0, bottom = 0;

    /// From a picture whose curves lie on none of the lines between left and right of the middle.
    explicit EnergyAxis(const Image& empty) {
        const int middle = plots_width * 3 / 10;  // of the second fifth
        const auto is_line = [&](int x, int y) {
            return brightness_at(empty, x, y) > brightness_at(empty, x, y - 2) + 12 &&
                   brightness_at(empty, x, y) > brightness_at(empty, x, y + 2) + 12;
        };
        for (int y = plots_height - 150; y < plots_height - 4; ++y) {
            int across = 0;
            for (int x = middle - 60; x < middle + 60; ++x) across += is_line(x, y);
            if (across < 110) continue;
            if (top == 0) top = y;
            bottom = y;
        }
        const auto ends = [&](int x) { return !is_line(x, top) && !is_line(x - 1, top) && !is_line(x + 1, top); };
        left = right = middle;
        while (left > 0 && !ends(left)) --left;
        while (right < plots_width && !ends(right)) ++right;
    }

    /// Where a curve of a colour runs at a part of the axis of time, as a part of the height.
    [[nodiscard]] std::optional<double> level(const Image& image, const Ink& ink, double along) const {
        const int x = left + static_cast<int>(std::lround(along * (right - left)));
        double sum = 0, weight = 0;
        for (int y = top - 3; y <= bottom + 3; ++y) {
            const std::uint8_t* p = image.pixel(x, y);
            const int apart = std::abs(p[0] - ink.red) + std::abs(p[1] - ink.green) + std::abs(p[2] - ink.blue);
            if (apart > 150) continue;
            sum += (150 - apart) * y;
            weight += 150 - apart;
        }
        if (weight == 0) return std::nullopt;
        return (bottom - sum / weight) / (bottom - top);
    }
};

TEST(PlotsPicture, HasEachValueWhereItBelongsOnBothAxes) {
    DrawnScene scene("drop");
    scene.settings.view.plots = true;
    StepReport report;
    scene.view.report = &report;

    const GlContext context = make_context();
    Renderer renderer;
    renderer.resize(plots_width, plots_height);
    const auto draw = [&](double time, double total, double kinetic) {
        report.time = time;
        report.energy = {.kinetic = kinetic, .gravity = total - kinetic, .spring = 0};
        renderer.draw(scene.view, Camera(scene.settings.view), {});
    };

    // One moment draws no curve
    draw(0, 8, 4);
    const EnergyAxis axis(renderer.read_back());
    ASSERT_GT(axis.bottom - axis.top, 30);
    ASSERT_GT(axis.right - axis.left, 150);

    // For five seconds 8 and 4 J, then 2 and 1 J: of an axis up to 8 J
    for (int k = 1; k <= 10; ++k) draw(0.5 * k, 8, 4);
    for (int k = 11; k <= 20; ++k) draw(0.5 * k, 2, 1);
    const Image picture = renderer.read_back();
    for (const double along : {0.1, 0.25, 0.45}) {
        EXPECT_NEAR(axis.level(picture, orange_ink, along).value_or(-1), 1, 0.04) << along;
        EXPECT_NEAR(axis.level(picture, sky_ink, along).value_or(-1), 0.5, 0.04) << along;
    }
    for (const double along : {0.58, 0.75, 0.95}) {
        EXPECT_NEAR(axis.level(picture, orange_ink, along).value_or(-1), 0.25, 0.04) << along;
        EXPECT_NEAR(axis.level(picture, sky_ink, along).value_or(-1), 0.125, 0.04) << along;
    }

    // Two and a half seconds later the fall is a quarter farther left
    for (int k = 21; k <= 25; ++k) draw(0.5 * k, 2, 1);
    const Image later = renderer.read_back();
    EXPECT_NEAR(axis.level(later, orange_ink, 0.2).value_or(-1), 1, 0.04);
    EXPECT_NEAR(axis.level(later, orange_ink, 0.33).value_or(-1), 0.25, 0.04);
}

}  // namespace
}  // namespace drape::test
