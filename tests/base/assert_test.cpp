#include "drape/base/assert.h"

#include <gtest/gtest.h>

#include "drape/base/workers.h"

/// Expects that a statement breaks a precondition and so ends its process. Builds that leave assertions out skip the
/// rest of the test.
#ifdef DRAPE_NO_ASSERT
#define EXPECT_ASSERTION(statement, condition) GTEST_SKIP() << "this build has no assertions"
#else
#define EXPECT_ASSERTION(statement, condition) EXPECT_DEATH(statement, "this is a bug in Drape: expected .*" condition)
#endif

namespace drape {
namespace {

TEST(AssertDeathTest, NamesTheConditionAndItsPlace) {
    DRAPE_ASSERT(1 + 1 == 2);
    EXPECT_DEATH(assertion_failed("x > 0", "cloth.cpp", 12), "cloth.cpp:12: this is a bug in Drape: expected x > 0");
    EXPECT_ASSERTION(DRAPE_ASSERT(1 + 1 == 3), "1 \\+ 1 == 3");
}

TEST(AssertDeathTest, HoldsForWorkers) {
    Workers workers(1);
    EXPECT_ASSERTION(workers.run(2, [](int) {}), "parts <= threads");
}

}  // namespace
}  // namespace drape
