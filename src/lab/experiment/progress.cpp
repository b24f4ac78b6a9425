#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <iostream>

#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr double pause_on_terminal = 0.2, pause_elsewhere = 30;  // s

}  // namespace

std::string rough_time(double seconds) {
    if (seconds < 90) return real_text(std::ceil(seconds)) + " s";
    if (seconds < 5400) return real_text(std::round(seconds / 60)) + " min";
    return real_text(std::round(seconds / 360) / 10) + " h";
}

Progress::Progress(std::size_t total) : total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (terminal_ && told_ > 0) std::cerr << "\r\x1b[K";
}

void Progress::advance() {
    ++done_;
    const double now = watch_.seconds();
    if (done_ == total_ || now - told_ < (terminal_ ? pause_on_terminal : pause_elsewhere)) return;
    told_ = now;
    const double left = now / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string text = fmt::format("{} of {} cases, about {} left", done_, total_, rough_time(left));
    std::cerr << (terminal_ ? "\r" + text + "\x1b[K" : text + "\n") << std::flush;
}

}  // namespace drape
