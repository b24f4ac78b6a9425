#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "drape/base/input_error.h"

namespace drape {

/// The exit codes of all programs.
enum ExitCode : int { Done = 0, Failed = 1, BadInput = 2 };

/// Parses a command line; `--help` and `--version` print their text.
/// @return false if a text was printed and there is nothing more to do
/// @throws InputError that names the option, the value and what is accepted
inline bool parse_command_line(CLI::App& app, int argc, char** argv) {
    app.set_version_flag("--version", app.get_name() + " " + DRAPE_VERSION);
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::Success& text) {
        app.exit(text);
        return false;
    } catch (const CLI::ParseError& error) {
        throw InputError(std::string(error.what()) + "\nSee " + app.get_name() + " --help.");
    }
}

/// What every `main` does: runs the program and turns what it throws into a message and an exit code.
/// @param run called as run(argc, argv), returns the exit code
template <class Run>
int run_program(const std::string& name, int argc, char** argv, Run run) {
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        std::cerr << name << ": " << error.what() << "\n";
        return BadInput;
    } catch (const std::exception& error) {
        std::cerr << name << ": " << error.what() << "\n";
        return Failed;
    }
}

}  // namespace drape
