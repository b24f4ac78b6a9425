#include "progress.h"

#include <unistd.h>

#include <iostream>

#include "drape/base/run_program.h"

namespace drape {

Progress::Progress(int pictures) : terminal_(::isatty(STDERR_FILENO) != 0), all_(pictures) {}

/// What is said of a failure starts on an empty line.
Progress::~Progress() { clear(); }

void Progress::count() {
    ++done_;
    const double pause = terminal_ ? 0.1 : 10;  // s
    if (watch_.seconds() < said_ + pause) return;
    said_ = watch_.seconds();
    shown_ = terminal_;
    std::cerr << (terminal_ ? "\r" : "") << done_ << " of " << all_ << " pictures" << (terminal_ ? "" : "\n")
              << std::flush;
}

void Progress::close(const std::filesystem::path& folder) {
    clear();
    tell(std::to_string(done_) + (done_ == 1 ? " picture in " : " pictures in ") + folder.string());
}

void Progress::clear() {
    if (shown_) std::cerr << "\r\033[K";
    shown_ = false;
}

}  // namespace drape
