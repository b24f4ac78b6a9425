#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

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

void sleep_for(double seconds);

/// Asks until it is so or the time is over.
template <class Condition>
bool eventually(Condition condition, double seconds = 60) {
    constexpr double pause = 0.05;  // s
    for (int turns = static_cast<int>(seconds / pause); turns > 0; --turns) {
        if (condition()) return true;
        sleep_for(pause);
    }
    return condition();
}

}  // namespace drape::test
