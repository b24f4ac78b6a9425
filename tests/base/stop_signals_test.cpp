#include "drape/base/stop_signals.h"

#include <gtest/gtest.h>

#include <csignal>

namespace drape {
namespace {

TEST(StopSignals, AreHeldBackAndToldOnce) {
    StopSignals signals;
    EXPECT_EQ(signals.arrived(), 0);
    std::raise(SIGTERM);
    EXPECT_EQ(signals.arrived(), SIGTERM);
    EXPECT_EQ(signals.arrived(), 0);
    std::raise(SIGINT);
    EXPECT_EQ(signals.arrived(), SIGINT);
}

TEST(StopSignals, EndTheProgramAgainOnceNobodyAsksAfterThem) {
    { StopSignals signals; }
    EXPECT_EXIT(std::raise(SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace drape
