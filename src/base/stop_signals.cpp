#include "drape/base/stop_signals.h"

#include <atomic>

#include "drape/base/assert.h"

namespace drape {
namespace {

// A handler is a function of the whole process and has nothing else to write to.
std::atomic<int> first_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

// The next signal of the same number ends the program by SA_RESETHAND, one of another number is sent on.
void take(int number) {
    int none = 0;
    if (first_signal.compare_exchange_strong(none, number)) return;
    struct sigaction by_default {};
    by_default.sa_handler = SIG_DFL;
    sigaction(number, &by_default, nullptr);
    raise(number);
}

}  // namespace

StopSignals::StopSignals() {
    struct sigaction ours {};
    ours.sa_handler = take;
    ours.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    first_signal = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        sigaction(numbers[i], nullptr, &before_[i]);
        DRAPE_ASSERT(before_[i].sa_handler != take);
        // Under nohup, or in the background of a script, a signal is not meant for this program
        if (before_[i].sa_handler == SIG_IGN) continue;
        sigaction(numbers[i], &ours, nullptr);
    }
}

StopSignals::~StopSignals() {
    for (std::size_t i = 0; i < numbers.size(); ++i) sigaction(numbers[i], &before_[i], nullptr);
}

int StopSignals::arrived() const { return first_signal; }

}  // namespace drape
