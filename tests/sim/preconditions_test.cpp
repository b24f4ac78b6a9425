// What a caller must hold to is checked where assertions are on, as they are in the tests.

#include "drape/sim/failure.h"
#include "drape/sim/scene.h"
#include "support/expect_assertion.h"

namespace drape {
namespace {

TEST(FailureDeathTest, RefusesToWriteOneThatHasNotHappened) {
    const Simulation simulation("drop", load_scene("drop"));
    EXPECT_ASSERTION(static_cast<void>(write_failure(simulation, ::testing::TempDir())), "Diverged");
}

}  // namespace
}  // namespace drape
