#pragma once

#include <string>
#include <string_view>

namespace drape {

/// The exit codes of all programs.
enum ExitCode : int { Done = 0, Failed = 1, BadInput = 2 };

/// Prints a message as one line on standard error; the names that it quotes do not reach the terminal as control
/// characters.
void tell(std::string_view message);

/// What every `main` does: runs the program and turns what it throws into a message and an exit code. Standard output
/// that could not be written fails the run. A file that grows beyond what is allowed (`ulimit -f`) is a failed write,
/// as on a full disk, and no signal.
/// @param run called as run(argc, argv), returns the exit code
int run_program(const std::string& name, int argc, char** argv, int (*run)(int, char**));

}  // namespace drape
