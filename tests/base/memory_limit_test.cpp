#include "drape/base/memory_limit.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>

#include "support/address_space.h"

namespace drape {
namespace {

TEST(MemoryLimit, IsAtMostWhatTheMachineHas) {
    const MemoryLimit limit = memory_limit();
    EXPECT_GT(limit.bytes, 1e6);
    EXPECT_LT(limit.bytes, 1e15);
    EXPECT_FALSE(limit.whose.empty());
}

#ifdef DRAPE_CAN_LIMIT_ADDRESS_SPACE
TEST(MemoryLimitDeathTest, IsThatOfTheProcessWhereThatIsLess) {
    const auto limit_myself = [] {
        rlimit space{};
        getrlimit(RLIMIT_AS, &space);
        space.rlim_cur = 50'000'000;
        setrlimit(RLIMIT_AS, &space);
        const MemoryLimit limit = memory_limit();
        std::_Exit(limit.bytes == 50'000'000 && limit.whose.find("ulimit -v") != limit.whose.npos ? 0 : 1);
    };
    EXPECT_EXIT(limit_myself(), ::testing::ExitedWithCode(0), "");
}
#endif

TEST(MemoryLimit, HasTextsOfTwoOrThreeDigits) {
    EXPECT_EQ(bytes_text(0), "0 MB");
    EXPECT_EQ(bytes_text(54.34e6), "54.3 MB");
    EXPECT_EQ(bytes_text(999e6), "999 MB");
    EXPECT_EQ(bytes_text(3.14159e9), "3.14 GB");
}

}  // namespace
}  // namespace drape
