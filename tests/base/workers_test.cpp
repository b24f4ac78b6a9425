#include "drape/base/workers.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>

namespace drape {
namespace {

TEST(Workers, DoEachPartOnceInEveryRound) {
    for (const int threads : {1, 2, 3, 7, 64}) {
        Workers workers(threads);
        EXPECT_EQ(workers.threads(), threads);
        std::array<int, 64> done{};
        const auto work = [&](int part) { ++done[static_cast<std::size_t>(part)]; };
        std::array<int, 64> expected{};
        for (int round = 0; round < 100; ++round) {
            const int parts = 1 + round % threads;
            workers.run(parts, std::cref(work));
            for (int part = 0; part < parts; ++part) ++expected[static_cast<std::size_t>(part)];
            ASSERT_EQ(done, expected) << "when run() has returned, round " << round << " of " << threads;
        }
    }
}

TEST(Workers, WakeAfterTheyHaveGoneToSleep) {
    Workers workers(3);
    std::atomic<int> done = 0;
    const auto work = [&](int) { ++done; };
    for (int round = 1; round <= 3; ++round) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        workers.run(3, std::cref(work));
        EXPECT_EQ(done, 3 * round);
    }
}

TEST(Workers, DoTheirPartsAtTheSameTime) {
    Workers workers(4);
    std::atomic<int> arrived = 0;
    const auto work = [&](int) {
        ++arrived;
        while (arrived < 4) std::this_thread::yield();  // for ever, if one came after another
    };
    workers.run(4, std::cref(work));
    EXPECT_EQ(arrived, 4);
}

TEST(Workers, AreMadeAndEndedWithoutWork) {
    for (int threads = 1; threads < 8; ++threads) const Workers idle(threads);
}

}  // namespace
}  // namespace drape
