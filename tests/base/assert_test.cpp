#include "drape/base/assert.h"

#include "drape/base/workers.h"
#include "support/expect_assertion.h"

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
