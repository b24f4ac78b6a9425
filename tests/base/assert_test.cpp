#include "drape/base/assert.h"

#include "drape/base/workers.h"
#include "support/expect_assertion.h"

namespace drape {
namespace {

TEST(AssertDeathTest, NamesTheConditionAndItsPlace) {
    EXPECT_ASSERTION(DRAPE_ASSERT(1 + 1 == 3), "1 \\+ 1 == 3");
    EXPECT_ASSERTION(DRAPE_ASSERT(false), "false");
}

TEST(AssertDeathTest, LetsWhatHoldsPass) { DRAPE_ASSERT(1 + 1 == 2); }

TEST(AssertDeathTest, HoldsForWorkers) {
    Workers workers(1);
    EXPECT_ASSERTION(workers.run(2, [](int) {}), "parts <= threads");
}

}  // namespace
}  // namespace drape
