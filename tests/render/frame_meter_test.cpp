#include "render/frame_meter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace drape {
namespace {

TEST(FrameMeter, ForgetsPicturesThatCameNowAndThen) {
    const auto wait = [](int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); };
    FrameMeter meter;
    wait(100);
    meter.count();
    EXPECT_LT(meter.rate(), 10.1);
    const Stopwatch watch;
    meter.begin_again();
    wait(20);
    meter.count();
    EXPECT_GE(meter.rate(), 1 / watch.seconds()) << "one picture, and no more than that time";
}

}  // namespace
}  // namespace drape
