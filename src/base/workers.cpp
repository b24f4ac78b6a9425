#include "drape/base/workers.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "drape/base/assert.h"

namespace drape {
namespace {

/// Returns when the value is no longer `old`: after looking for as long as a short loop takes, asleep.
void wait_while(const std::atomic<int>& value, int old) {
    constexpr int looks = 100;
    for (int look = 0; look < looks; ++look) {
        if (value.load(std::memory_order_acquire) != old) return;
        std::this_thread::yield();
    }
    value.wait(old, std::memory_order_acquire);
}

/// Once in a program, however often it happens.
void warn_of_few_threads(int wanted, int started, const std::exception& error) {
    static std::atomic_flag warned;
    if (warned.test_and_set()) return;
    std::fprintf(stderr, "warning: %d of %d threads run, for no more can be started (%s); the results are the same\n",
                 started, wanted, error.what());
}

}  // namespace

Workers::Workers(int threads) : errors_(static_cast<std::size_t>(std::max(threads, 1))) {
    DRAPE_ASSERT(threads >= 1);
    own_.reserve(static_cast<std::size_t>(threads));
    try {
        for (int part = 1; part < threads; ++part) own_.emplace_back([this, part] { serve(part); });
    } catch (const std::exception& error) {
        warn_of_few_threads(threads, this->threads(), error);
    }
}

Workers::~Workers() {
    closing_ = true;
    ++round_;
    round_.notify_all();
    for (std::thread& thread : own_) thread.join();
}

void Workers::run(int parts, const std::function<void(int)>& work) {
    DRAPE_ASSERT(parts >= 1 && parts <= threads());
    if (parts == 1) return work(0);
    work_ = &work;
    parts_ = parts;
    working_ = static_cast<int>(own_.size());
    ++round_;
    round_.notify_all();
    do_part(0);
    for (int working = working_; working > 0; working = working_) wait_while(working_, working);
    rethrow_first(parts);
}

void Workers::do_part(int part) noexcept {
    try {
        (*work_)(part);
    } catch (...) {
        errors_[static_cast<std::size_t>(part)] = std::current_exception();
    }
}

/// Forgets what the others have thrown.
void Workers::rethrow_first(int parts) {
    std::exception_ptr first;
    for (auto part = static_cast<std::size_t>(parts); part-- > 0;) {
        if (errors_[part]) first = std::exchange(errors_[part], nullptr);
    }
    if (first) std::rethrow_exception(first);
}

void Workers::serve(int part) {
    for (int round = 0;; ++round) {
        wait_while(round_, round);
        if (closing_) return;
        if (part < parts_) do_part(part);
        --working_;
        working_.notify_one();
    }
}

}  // namespace drape
