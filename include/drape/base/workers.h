#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

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

}  // namespace drape
