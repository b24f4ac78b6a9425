#pragma once

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>

#include "drape/base/input_error.h"
#include "drape/base/standard_streams.h"

namespace drape {

/// The exit codes of all programs.
enum ExitCode : int { Done = 0, Failed = 1, BadInput = 2 };

/// Prints an error in one line, or two where it has a hint; what it quotes does not reach the terminal as control
/// characters.
inline void print_error(const std::string& name, std::string_view message) {
    const std::size_t end = std::min(message.find('\n'), message.size());
    std::cerr << name << ": " << one_line(message.substr(0, end)) << "\n";
    if (end < message.size()) std::cerr << one_line(message.substr(end + 1)) << "\n";
}

/// What every `main` does: runs the program and turns what it throws into a message and an exit code. Standard output
/// that could not be written fails the run. A file that grows beyond what is allowed (`ulimit -f`) is a failed write,
/// as on a full disk, and no signal.
/// @param run called as run(argc, argv), returns the exit code
template <class Run>
int run_program(const std::string& name, int argc, char** argv, Run run) {
    keep_standard_streams_apart();
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        const int exit_code = run(argc, argv);
        if (exit_code == Done && !std::cout.flush()) throw RunError("standard output could not be written whole");
        return exit_code;
    } catch (const InputError& error) {
        print_error(name, error.what());
        return BadInput;
    } catch (const std::bad_alloc&) {
        print_error(name, "out of memory");
        return Failed;
    } catch (const std::exception& error) {
        print_error(name, error.what());
        return Failed;
    }
}

}  // namespace drape
