#pragma once

#include <gtest/gtest.h>

/// Expects that a statement breaks a precondition and so ends its process. Builds that leave assertions out skip the
/// rest of the test.
#ifdef DRAPE_NO_ASSERT
#define EXPECT_ASSERTION(statement, condition) GTEST_SKIP() << "this build has no assertions"
#else
#define EXPECT_ASSERTION(statement, condition) EXPECT_DEATH(statement, "this is a bug in Drape: expected .*" condition)
#endif
