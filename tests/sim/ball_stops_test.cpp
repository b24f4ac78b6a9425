// What stops a ball under the keys: cloth that is taut, and pins.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "drape/model/stretch_limit.h"
#include "small_scene.h"

namespace drape {
namespace {

/// Of the thickness, that is left between a ball and a pin at least.
constexpr Real kept_part = Real(0.9);

/// The cloth of `original`, which four pins hold, and the ball below it.
class StoppedBall : public testing::Test {
protected:
    void start(const std::vector<std::string>& assignments) {
        simulation_.emplace(shipped_simulation("original", assignments));
    }

    void steer(const std::string& direction, double seconds) {
        send(*simulation_, "steer " + direction);
        longest_ = 0, nearest_ = 1;
        run_until(*simulation_, simulation_->report().time + seconds, [this] {
            longest_ = std::max(longest_, largest_stretch(cloth().model, cloth().state.x));
            nearest_ = std::min(nearest_, gap_to_pins());
        });
    }

    [[nodiscard]] const Ball& ball() const { return simulation_->balls()[0]; }
    [[nodiscard]] const Cloth& cloth() const { return simulation_->cloths()[0]; }
    [[nodiscard]] Real thickness() const { return simulation_->settings().contact.thickness; }

    /// From the ball's surface to the nearest pin [m].
    [[nodiscard]] Real gap_to_pins() const {
        Real gap = 1;
        for (int p = 0; p < cloth().model.grid.particles(); ++p) {
            if (!cloth().model.pinned(p)) continue;
            gap = std::min(gap, (cloth().state.x.row(p).transpose() - ball().centre).norm() - ball().radius);
        }
        return gap;
    }

    std::optional<Simulation> simulation_;
    Real longest_ = 0, nearest_ = 1;  ///< stretch, and gap to a pin [m], while the ball was steered last
};

using LongStoppedBall = StoppedBall;

TEST_F(LongStoppedBall, DoesNotStretchClothThatPinsHoldTautButSlidesAlongIt) {
    start({});
    const Real limit = cloth().model.stretch_limit, from = ball().centre.y();
    steer("0 1 0", 1);
    EXPECT_GT(longest_, limit + Real(0.01)) << "it comes as far as the cloth lets it";
    EXPECT_LT(longest_, limit + Real(0.05));
    EXPECT_LT(ball().velocity.norm(), 0.1);
    const Vec3 highest = ball().centre;
    EXPECT_GT(highest.y(), from + Real(0.2));
    // Towards a side it goes lower, where cloth between the pins lets it
    steer("0.8 0.6 0", 0.5);
    EXPECT_GT(longest_, limit + Real(0.01)) << "the cloth is taut";
    EXPECT_LT(longest_, limit + Real(0.05));
    EXPECT_GT(ball().centre.x(), highest.x() + Real(0.01));
    EXPECT_LT(ball().centre.y(), highest.y());
    steer("0 -1 0", 0.3);
    EXPECT_LT(ball().centre.y(), highest.y() - Real(0.2)) << "it can go back";
}

TEST_F(LongStoppedBall, PushesClothWithoutALimitAsFarAsTheKeysLeadIt) {
    start({"stretch_limit=0"});
    const Real from = ball().centre.y();
    steer("0 1 0", 1.5);
    EXPECT_GT(ball().centre.y(), from + Real(0.9) * Real(1.4) * simulation_->settings().balls[0].speed);
}

TEST_F(StoppedBall, NeverMovesOverAPinButSlidesPastIt) {
    start({"stretch_limit=0"});
    steer("-0.67 0.31 -0.67", 2);
    EXPECT_GT(nearest_, thickness() * kept_part);
    EXPECT_LT(nearest_, thickness() * 2) << "it comes to the pin";
    start({"ball.position=-0.9,0,-0.6", "stretch_limit=0"});
    steer("1 0 0", 1.5);
    EXPECT_GT(nearest_, thickness() * kept_part);
    EXPECT_LT(nearest_, thickness() * 2);
    EXPECT_GT(ball().centre.x(), -0.2);
}

/// Between two pins that are nearer to each other than its diameter, and on the ground below one.
TEST_F(LongStoppedBall, IsNotPressedOverPinsByWhatElseStopsIt) {
    for (const bool between : {true, false}) {
        start({"pinned=0,10", "stretch_limit=0", "dt=1e-3", "integrator=backward_euler", "cloth.drag=0.01"});
        if (!between) send(*simulation_, "set ground.height=-0.3");
        send(*simulation_, between ? "set ball.position=-0.32,0,-0.9" : "set ball.position=-0.5,-0.05,-0.95");
        steer("0 0 1", 1.5);
        EXPECT_GT(nearest_, thickness() * kept_part) << between;
        EXPECT_LT(nearest_, thickness() * 2) << between << ": it comes to the pin";
        EXPECT_LT(ball().centre.z(), -0.5) << between;
        EXPECT_GE(ball().centre.y(), simulation_->settings().ground.height + ball().radius + thickness());
    }
}

TEST_F(StoppedBall, ThatHasAPinInItBringsItNoNearerAndMayLeave) {
    start({"ball.position=-0.45,-0.05,-0.45", "stretch_limit=0"});
    const Real deepest = gap_to_pins();
    ASSERT_LT(deepest, -0.1);
    const Vec3 from = ball().centre;
    steer("-0.577 0.577 -0.577", 0.2);
    EXPECT_GE(nearest_, deepest - Real(1e-6));
    EXPECT_LT((ball().centre - from).norm(), 0.001);
    steer("0.67 -0.31 0.67", 1);
    EXPECT_GT(gap_to_pins(), 0.1);
}

}  // namespace
}  // namespace drape
