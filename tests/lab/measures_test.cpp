#include <gtest/gtest.h>

#include <thread>

#include "lab/measure/statistics.h"

namespace drape {
namespace {

TEST(Quartiles, LieBetweenTheValuesWhereTheyMust) {
    const Quartiles odd = quartiles_of({5, 1, 3, 2, 4}), even = quartiles_of({4, 1, 2, 3});
    EXPECT_DOUBLE_EQ(odd.lower, 2);
    EXPECT_DOUBLE_EQ(odd.median, 3);
    EXPECT_DOUBLE_EQ(odd.upper, 4);
    EXPECT_DOUBLE_EQ(even.lower, 1.75);
    EXPECT_DOUBLE_EQ(even.median, 2.5);
    EXPECT_DOUBLE_EQ(even.upper, 3.25);
    EXPECT_DOUBLE_EQ(quartiles_of({7}).upper, 7);
}

TEST(ThreadCpuTime, CountsOnlyWork) {
    const double before = thread_cpu_time();
    const timespec pause{0, 30'000'000};
    nanosleep(&pause, nullptr);
    EXPECT_LT(thread_cpu_time() - before, 0.015) << "sleep is no work";
}

TEST(ProgramCpuTime, CountsTheWorkOfOtherThreads) {
    const double own = thread_cpu_time(), all = program_cpu_time();
    std::thread([] {
        for (const double start = thread_cpu_time(); thread_cpu_time() - start < 0.05;) {
        }
    }).join();
    EXPECT_GE(program_cpu_time() - all, 0.05);
    EXPECT_LT(thread_cpu_time() - own, 0.05);
}

}  // namespace
}  // namespace drape
