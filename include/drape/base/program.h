#pragma once

#include <CLI/CLI.hpp>
#include <cctype>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "drape/base/input_error.h"

namespace drape {

/// The exit codes of all programs.
enum ExitCode : int { Done = 0, Failed = 1, BadInput = 2 };

/// What is wrong with a command line: first of all a word that nothing expects, with the nearest one that is known.
inline std::string command_line_fault(const CLI::App& app, const CLI::ParseError& error) {
    const auto unexpected = app.remaining(true);
    if (unexpected.empty()) return error.what();
    const std::string& word = unexpected.front();
    std::vector<std::string> known;
    const auto add_options = [&known](const CLI::App& of) {
        for (const CLI::Option* option : of.get_options()) {
            for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
        }
    };
    const auto chosen = app.get_subcommands();
    if (word.starts_with('-')) {
        add_options(app);
        for (const CLI::App* command : chosen) add_options(*command);
    } else if (chosen.empty()) {
        for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
            known.push_back(command->get_name());
        }
    }
    const std::string nearest = nearest_name(word, known);
    return "unexpected '" + word.substr(0, 100) + "'" + (nearest.empty() ? "" : ": did you mean '" + nearest + "'?");
}

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
        throw InputError(command_line_fault(app, error) + "\nSee " + app.get_name() + " --help.");
    }
}

/// Prints an error; what it quotes from a file does not reach the terminal as control characters.
inline void print_error(const std::string& name, std::string message) {
    for (char& c : message) {
        if (std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\n') c = '?';
    }
    std::cerr << name << ": " << message << "\n";
}

/// What every `main` does: runs the program and turns what it throws into a message and an exit code. Standard output
/// that could not be written fails the run.
/// @param run called as run(argc, argv), returns the exit code
template <class Run>
int run_program(const std::string& name, int argc, char** argv, Run run) {
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
