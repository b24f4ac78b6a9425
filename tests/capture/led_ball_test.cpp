// Of several balls, the one that the keys lead has a red ring.

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_scene.h"

namespace drape::test {
namespace {

TEST(SteeredBall, HasARedRingAndNothingElseIsChanged) {
    DrawnScene scene("three_balls");
    const Image without = picture_of(scene.view, 640, 480);
    scene.view.steered_ball = 1;
    const Image with = picture_of(scene.view, 640, 480);
    ASSERT_EQ(with.rgb.size(), without.rgb.size());
    int redder = 0, other = 0;
    for (std::size_t p = 0; p + 2 < with.rgb.size(); p += 3) {
        const auto red_of = [p](const Image& image) { return 2 * image.rgb[p] - image.rgb[p + 1] - image.rgb[p + 2]; };
        if (std::equal(&with.rgb[p], &with.rgb[p] + 3, &without.rgb[p])) continue;
        ++(red_of(with) > red_of(without) ? redder : other);
    }
    EXPECT_GT(redder, 60);
    EXPECT_EQ(other, 0);
}

TEST(SteeredBall, IsOneOfSeveralThatTheKeysHaveTakenOver) {
    Simulation several("three_balls", load_scene("three_balls")), single("original", load_scene("original"));
    EXPECT_EQ(several.view().steered_ball, -1) << "the keys lead none yet";
    several.apply(command::Steer{{1, 0, 0}});
    single.apply(command::Steer{{1, 0, 0}});
    EXPECT_EQ(several.view().steered_ball, 1) << "the first that is free";
    EXPECT_EQ(single.view().steered_ball, -1) << "there is no other";
    several.apply(command::Reset{});
    EXPECT_EQ(several.view().steered_ball, -1);
}

}  // namespace
}  // namespace drape::test
