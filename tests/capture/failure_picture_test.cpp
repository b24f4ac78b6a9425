// The particle that has diverged first and the worst of its springs are marked, also behind the cloth.

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_scene.h"
#include "expected_picture.h"

namespace drape::test {
namespace {

constexpr int failed_width = 960, failed_height = 720;

struct FailurePicture : DrawnScene, testing::Test {
    FailurePicture() : DrawnScene("drop", 0.8) { view.report = &report; }

    [[nodiscard]] Image draw() const { return picture_of(view, failed_width, failed_height); }

    StepReport report = simulation.report();
};

bool is_white(const std::uint8_t* p) { return p[0] > 235 && p[1] > 235 && p[2] > 235; }

TEST_F(FailurePicture, MarksTheParticleAndItsSpringThroughTheCloth) {
    const ExpectedPicture expected(view, failed_width, failed_height);
    const Image plain = draw();
    int hidden = 0;
    for (int p = 31; p < cloth().model.grid.particles() && hidden < 3; p += 7) {
        const auto spot = expected.project(cloth().x.row(p).transpose());
        const auto other = expected.project(cloth().x.row(p - 1).transpose());
        const int x = static_cast<int>(spot.x), y = static_cast<int>(spot.y);
        if (expected.at(x, y) == Seen::Nothing || spot.depth < expected.depth(x, y) + 0.05) continue;
        ++hidden;
        report.status = Status::Diverged;
        report.failure = {0, p, p - 1};
        const Image marked = draw();

        // All around the particle, and along the spring; nowhere else
        for (int turn = 0; turn < 16; ++turn) {
            const double angle = turn * 0.3927;
            const int i = static_cast<int>(spot.x + 15 * std::cos(angle));
            const int j = static_cast<int>(spot.y + 15 * std::sin(angle));
            EXPECT_TRUE(is_white(marked.pixel(i, j))) << p << ", " << turn;
        }
        const double length = std::hypot(other.x - spot.x, other.y - spot.y);
        for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            if (std::abs(part * length - 15) < 6) continue;  // under the ring
            const int i = static_cast<int>(spot.x + part * (other.x - spot.x));
            const int j = static_cast<int>(spot.y + part * (other.y - spot.y));
            EXPECT_TRUE(is_white(marked.pixel(i, j))) << p << ", " << part;
        }
        int elsewhere = 0;
        for (int j = 0; j < failed_height; ++j) {
            for (int i = 0; i < failed_width; ++i) {
                if (std::hypot(i - spot.x, j - spot.y) < 24 + length) continue;
                elsewhere += is_white(marked.pixel(i, j)) && !is_white(plain.pixel(i, j));
            }
        }
        EXPECT_EQ(elsewhere, 0);
    }
    EXPECT_EQ(hidden, 3);
}

TEST_F(FailurePicture, MarksNothingWhileAllIsWellOrWhereNothingIs) {
    const Image plain = draw();
    report.failure = {0, 100, 101};
    EXPECT_EQ(draw().rgb, plain.rgb) << "it has not diverged";
    report.status = Status::Diverged;
    EXPECT_NE(draw().rgb, plain.rgb);
    for (const FailureSpot& nowhere : {FailureSpot{}, FailureSpot{1, 100, 101}, FailureSpot{0, 900, 100}}) {
        report.failure = nowhere;
        EXPECT_EQ(draw().rgb, plain.rgb);
    }
}

}  // namespace
}  // namespace drape::test
