#include "drape/base/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "support/address_space.h"
#include "support/process.h"

namespace drape {
namespace {

TEST(Workers, DoEachPartOnceInEveryRound) {
    for (const int threads : {1, 2, 3, 7, 64}) {
        const Workers idle(threads);  // ends without work
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

// The threads of this program, by their numbers.
std::set<std::string> thread_numbers() {
    std::set<std::string> numbers;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", ignored)) {
        numbers.insert(entry.path().filename());
    }
    return numbers;
}

// Whether the system says that a thread sleeps.
bool thread_sleeps(const std::string& number) {
    const std::string text = test::read_file("/proc/self/task/" + number + "/stat");
    return text.find(") S ") != std::string::npos;
}

TEST(Workers, WakeAfterTheyHaveGoneToSleep) {
    std::thread([] {}).join();  // with the first thread, a sanitizer starts one of its own
    const std::set<std::string> before = thread_numbers();
    if (before.empty()) GTEST_SKIP() << "the system does not tell its threads";
    Workers workers(3);
    std::set<std::string> own = thread_numbers();
    for (const std::string& number : before) own.erase(number);
    ASSERT_EQ(own.size(), 2u);
    std::atomic<int> done = 0;
    const auto work = [&](int) { ++done; };
    for (int round = 1; round <= 3; ++round) {
        ASSERT_TRUE(test::eventually([&] { return std::ranges::all_of(own, thread_sleeps); })) << "they do not sleep";
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

/// What comes out of a round of four parts of which some throw their number; "" if nothing.
std::string thrown_by(Workers& workers, const std::set<int>& throwing, std::atomic<int>& ended) {
    const auto work = [&](int part) {
        if (throwing.contains(part)) throw std::runtime_error(std::to_string(part));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the others have thrown long since
        ++ended;
    };
    try {
        workers.run(4, std::cref(work));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(Workers, EndAllPartsBeforeTheErrorOfTheLowestOneIsThrown) {
    Workers workers(4);
    const std::vector<std::set<int>> cases{{0}, {1}, {0, 1}, {1, 3}, {0, 1, 2, 3}};
    for (int round = 0; round < 5; ++round) {
        for (const std::set<int>& throwing : cases) {
            std::atomic<int> ended = 0;
            EXPECT_EQ(thrown_by(workers, throwing, ended), std::to_string(*throwing.begin()));
            EXPECT_EQ(ended, 4 - static_cast<int>(throwing.size())) << "parts that ended before the error came out";
            ended = 0;
            EXPECT_EQ(thrown_by(workers, {}, ended), "") << "of the round after it";
            EXPECT_EQ(ended, 4);
        }
    }
}

#ifdef DRAPE_CAN_LIMIT_ADDRESS_SPACE
TEST(WorkersDeathTest, AreFewerWhereThreadsCannotBeStarted) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto work_with_few = [] {
        test::limit_address_space(100'000'000);  // about ten stacks
        Workers workers(64);
        const int threads = workers.threads();
        std::atomic<int> done = 0;
        const auto work = [&](int) { ++done; };
        workers.run(threads, std::cref(work));
        const Workers again(64);  // says nothing more
        std::exit(threads >= 1 && threads < 64 && done == threads ? 0 : 1);
    };
    EXPECT_EXIT(work_with_few(), ::testing::ExitedWithCode(0), "^warning: [0-9]+ of 64 threads run, .*\n$");
}
#endif

}  // namespace
}  // namespace drape
