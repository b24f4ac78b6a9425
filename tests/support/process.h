#pragma once

#include <sys/types.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drape/base/stopwatch.h"

namespace drape::test {

/// A program that runs beside the test; ended with it.
class Process {
public:
    /// @param words program and arguments
    /// @param environment changes to this process's own; an empty value unsets
    /// @param folder where it runs; its output goes to `stdout.txt` and `stderr.txt` there
    Process(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment,
            const std::filesystem::path& folder);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void send(int signal) const;

    [[nodiscard]] bool running();

    /// The exit code, or 256 + the signal that ended it; nothing if it has not ended in time.
    std::optional<int> wait(double seconds);

    /// As `wait`, however long it takes.
    int wait_to_end();

    [[nodiscard]] std::string standard_output() const;
    [[nodiscard]] std::string standard_error() const;

    /// Processor time used so far [s].
    [[nodiscard]] double processor_time() const;

    /// How often its first thread has gone to sleep by itself so far.
    [[nodiscard]] long long sleeps() const;

private:
    std::filesystem::path folder_;
    pid_t id_ = -1;
    std::optional<int> status_;
};

/// The whole of a file; empty if there is none.
std::string read_file(const std::filesystem::path& file);

/// The names in a folder, sorted; none if there is no folder.
std::vector<std::string> names_in(const std::filesystem::path& folder);

void sleep_for(double seconds);

/// Asks until it is so or the time is over: often at first, then less and less often.
template <class Condition>
bool eventually(Condition condition, double seconds = 60) {
    constexpr double first_pause = 0.001, longest_pause = 0.05;  // s
    const Stopwatch watch;
    for (double pause = first_pause;; pause = std::min(1.5 * pause, longest_pause)) {
        const bool last = watch.seconds() >= seconds;
        if (condition()) return true;
        if (last) return false;
        sleep_for(pause);
    }
}

}  // namespace drape::test
