#include "drape/base/progress.h"

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <utility>

#include "drape/base/numbers.h"
#include "drape/base/run_program.h"

namespace drape {
namespace {

/// A time that is left, as people say it: "2 min", "40 s".
std::string rough_time(double seconds) {
    if (seconds < 90) return real_text(std::ceil(seconds)) + " s";
    if (seconds < 5400) return real_text(std::round(seconds / 60)) + " min";
    return real_text(std::round(seconds / 360) / 10) + " h";
}

}  // namespace

Progress::Progress(std::size_t total, std::string noun)
    : total_(total), noun_(std::move(noun)), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::advance() {
    ++done_;
    const double now = watch_.seconds(), pause = terminal_ ? 0.2 : 10;  // s
    if (done_ >= total_ || now - told_ < pause) return;
    told_ = now;
    shown_ = terminal_;
    const double left = now / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string text = std::to_string(done_) + " of " + std::to_string(total_) + " " + noun_ + "s, about " +
                             rough_time(left) + " left";
    std::cerr << (terminal_ ? "\r" + text + "\x1b[K" : text + "\n") << std::flush;
}

void Progress::close(const std::filesystem::path& folder) {
    clear();
    tell(std::to_string(done_) + " " + noun_ + (done_ == 1 ? "" : "s") + " in " + folder.string());
}

void Progress::clear() {
    if (shown_) std::cerr << "\r\x1b[K";
    shown_ = false;
}

}  // namespace drape
