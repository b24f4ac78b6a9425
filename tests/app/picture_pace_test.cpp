#include "../../src/app/picture_pace.h"

#include <gtest/gtest.h>

namespace drape {
namespace {

constexpr double slow = 2 * PicturePace::longest, quick = PicturePace::shortest / 2;

// A pace that has seen a row of slow pictures
PicturePace after_slow_pictures() {
    PicturePace pace;
    pace.follow(true, slow);
    for (double lost = 0; lost < PicturePace::max_lost; lost += slow) pace.drew(false, slow);
    return pace;
}

TEST(PicturePace, DrawsInFullUntilARowOfPicturesWasSlow) {
    PicturePace pace;
    pace.follow(true, slow);
    for (int i = 0; i < 31; ++i) pace.drew(false, i % 3 == 0 ? quick : slow);
    EXPECT_FALSE(pace.prefer_speed()) << "slow now and then";
    for (int i = 1; i < PicturePace::min_slow; ++i) pace.drew(false, 10 * PicturePace::max_lost);
    EXPECT_FALSE(pace.prefer_speed()) << "first pictures take long";
    pace.drew(false, slow);
    EXPECT_TRUE(pace.prefer_speed());
}

TEST(PicturePace, DrawsWhatStandsStillInFullOnce) {
    PicturePace pace = after_slow_pictures();
    pace.drew(true, slow);
    EXPECT_FALSE(pace.unfinished()) << "it still moves";
    pace.follow(false, PicturePace::patience / 2);
    EXPECT_TRUE(pace.prefer_speed()) << "it may go on at once";
    pace.follow(false, PicturePace::patience);
    EXPECT_TRUE(pace.unfinished());
    EXPECT_FALSE(pace.prefer_speed());
    pace.drew(false, slow);
    EXPECT_FALSE(pace.unfinished()) << "once is enough";
    pace.follow(true, 0.01);
    EXPECT_TRUE(pace.prefer_speed()) << "it moves again";
}

TEST(PicturePace, TriesFullPicturesAgainWhereFastOnesTakeNearlyNoTime) {
    PicturePace still = after_slow_pictures(), pace = still;
    for (int i = 0; i < 2 * PicturePace::min_quick; ++i) still.drew(false, quick);
    EXPECT_TRUE(still.prefer_speed()) << "full pictures of what stands still teach nothing";
    for (int i = 1; i < PicturePace::min_quick; ++i) pace.drew(true, quick);
    EXPECT_TRUE(pace.prefer_speed());
    pace.drew(true, quick);
    EXPECT_FALSE(pace.prefer_speed());
}

TEST(PicturePace, DoesNotGoBackAndForthWhereOnlyFastPicturesAreQuick) {
    PicturePace pace = after_slow_pictures();
    int changes = 0;
    for (int i = 0; i < 10'000; ++i) {
        pace.follow(true, quick);
        const bool was_fast = pace.prefer_speed();
        pace.drew(was_fast, was_fast ? quick : slow);
        if (pace.prefer_speed() != was_fast) ++changes;
    }
    EXPECT_GT(changes, 0);
    EXPECT_LT(changes, 20);
}

TEST(SceneClock, StartsWithTheFirstPictureAndInSmallSteps) {
    SceneClock clock;
    EXPECT_EQ(clock.pass(10 * slow), 0) << "nobody has seen the scene";
    EXPECT_TRUE(clock.begin());
    EXPECT_EQ(clock.pass(quick), quick);
    double shown = quick;
    while (shown < SceneClock::opening) {
        const double passed = clock.pass(10 * slow);
        ASSERT_GT(passed, 0);
        ASSERT_LE(passed, PicturePace::longest);
        EXPECT_FALSE(clock.begin()) << "the next picture";
        shown += passed;
    }
    EXPECT_EQ(clock.pass(slow), slow) << "by now the picture is coarse";
}

}  // namespace
}  // namespace drape
