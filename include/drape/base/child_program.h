#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace drape {

/// Another program that runs beside this one. It starts with no signal blocked, and ignores none that this program
/// ignores for itself. What it prints goes where this program's own does.
class ChildProgram {
public:
    /// What the program reads: what this one would, or what is written to `feed`. One that is fed is no part of this
    /// program's process group: what Ctrl-C interrupts here, it may finish.
    enum class Input { Shared, Fed };

    /// @param words the program, by its path or as PATH finds it from here, and its arguments
    /// @param folder in which it starts; empty: this program's own
    ChildProgram(std::vector<std::string> words, Input input, const std::filesystem::path& folder = {});
    ~ChildProgram();
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    /// Why it could not be started, as errno; 0 if it was.
    [[nodiscard]] int error() const { return error_; }

    /// The writing end of a pipe that it reads, which does not block; -1 if it is not fed, or no longer.
    [[nodiscard]] int feed() const { return feed_; }

    /// Ends what it reads.
    void end_feed();

    /// Waits for its end.
    /// @return its exit code, or 128 + the signal that ended it
    int wait();

    /// Waits for its end for so long.
    /// @return nothing if it runs still
    std::optional<int> wait(double seconds);

    /// Ends it, even if it is stopped.
    void kill();

private:
    std::optional<int> look(bool blocking);

    pid_t process_ = -1;
    int feed_ = -1;
    int error_ = 0;
    std::optional<int> code_;
};

/// Runs another program to its end, with this one's input.
/// @param folder in which it starts; empty: this program's own
/// @return its exit code, or 128 + the signal that ended it; nothing if there is no such program
/// @throws RunError if it cannot be started for another reason
std::optional<int> run_child(std::vector<std::string> words, const std::filesystem::path& folder = {});

/// Goes on as another program.
/// @param words the path of the program, and its arguments
/// @throws RunError if that cannot be started
[[noreturn]] void become_program(std::vector<std::string> words);

}  // namespace drape
