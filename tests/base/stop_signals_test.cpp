#include "drape/base/stop_signals.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace drape {
namespace {

TEST(StopSignals, AreTakenWhateverThreadTheyCome) {
    std::atomic<bool> done = false;
    std::thread before([&] {
        while (!done) std::this_thread::yield();
    });
    const StopSignals signals;
    pthread_kill(before.native_handle(), SIGTERM);
    while (signals.arrived() == 0) std::this_thread::yield();
    EXPECT_EQ(signals.arrived(), SIGTERM);
    done = true;
    before.join();
}

TEST(StopSignals, LeaveAHangUpIgnoredThatIs) {
    std::signal(SIGHUP, SIG_IGN);
    {
        const StopSignals signals;
        std::raise(SIGHUP);
        EXPECT_EQ(signals.arrived(), 0);
    }
    std::signal(SIGHUP, SIG_DFL);
}

TEST(StopSignals, EndTheProgramAgainOnceNobodyAsksAfterThem) {
    { const StopSignals signals; }
    EXPECT_EXIT(std::raise(SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace drape
