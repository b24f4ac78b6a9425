#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "drape/base/copied.h"

namespace drape {

/// A fixed number of threads that share a loop: the caller's own and some that wait for work.
/// Between two loops they look for the next one for a few microseconds, then sleep.
class Workers {
public:
    /// Where the system refuses to start so many threads, says so on standard error and goes on with fewer.
    /// @param threads the caller's own included, at least 1
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    [[nodiscard]] int threads() const { return static_cast<int>(own_.size()) + 1; }

    /// Calls work(0) ... work(parts - 1), each once and all at the same time, and returns when they have returned.
    /// @param work hand a lambda over by std::ref, for a std::function may allocate a copy of it
    /// @pre 1 <= parts <= threads()
    /// @throws what the lowest of the parts that threw has thrown, after all of them have ended
    /// @par Cost some microseconds; none for a single part, which runs as a plain call. No allocation.
    void run(int parts, const std::function<void(int)>& work);

private:
    void serve(int part);
    void do_part(int part) noexcept;
    void rethrow_first(int parts);

    const std::function<void(int)>* work_ = nullptr;
    int parts_ = 0;
    bool closing_ = false;
    std::atomic<int> round_ = 0;              ///< changes when there is work; what stands above is written before
    std::atomic<int> working_ = 0;            ///< own threads that have not yet finished the round
    std::vector<std::exception_ptr> errors_;  ///< what each part of the round has thrown
    std::vector<std::thread> own_;
};

/// Workers that start when there is work for more than one of them; a copy starts its own.
class LazyWorkers {
public:
    /// @param threads the caller's own included, at least 1
    void use(int threads) {
        if (threads != threads_) workers_.reset();
        threads_ = threads;
    }

    /// Calls work(part, parts) for each of some parts, see `Workers::run`.
    /// @param most parts that the work is worth; there are no more than threads, and one or more
    template <class Work>
    void run(std::size_t most, Work work) {
        int parts = static_cast<int>(std::clamp<std::size_t>(most, 1, static_cast<std::size_t>(threads_)));
        if (parts > 1 && !workers_) workers_ = std::make_shared<Workers>(threads_);
        if (parts > 1) parts = std::min(parts, workers_->threads());
        if (parts == 1) return work(0, 1);
        const auto part_of = [&](int part) { work(part, parts); };
        workers_->run(parts, std::cref(part_of));
    }

private:
    int threads_ = 1;
    ScratchOnCopy<std::shared_ptr<Workers>> workers_;
};

}  // namespace drape
