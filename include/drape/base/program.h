#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/run_program.h"

namespace drape {

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
    return "unexpected '" + shortened(word) + "'" + (nearest.empty() ? "" : ": did you mean '" + nearest + "'?");
}

/// The second line of what is said of a bad command line.
inline std::string help_hint(const CLI::App& app) { return "See " + app.get_name() + " --help."; }

/// Whether a word is an option of one of these: "--out", or "-h".
inline bool is_option(const std::string& word, std::span<const CLI::App* const> commands, bool with_value = false) {
    return std::ranges::any_of(commands, [&](const CLI::App* command) {
        const CLI::Option* option = word.starts_with('-') ? command->get_option_no_throw(word) : nullptr;
        return option != nullptr && !(with_value && option->get_items_expected_max() == 0);
    });
}

/// Refuses an option where another one's value should be, which the parser would take for the value; and empty words,
/// which would be taken for what was not given: a shell makes one of a variable that is not set.
/// @throws InputError
inline void check_values(const CLI::App& app, std::span<char* const> words) {
    std::vector<const CLI::App*> commands = app.get_subcommands([](const CLI::App*) { return true; });
    commands.push_back(&app);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i], option = word.substr(0, word.size() - 1);
        const bool has_value = !word.ends_with('=') || !word.starts_with("--") || !is_option(option, commands, true);
        if (!word.empty() && has_value) continue;
        throw InputError((word.empty() ? "word " + std::to_string(i) + " is empty" : word + " has no value") +
                             ": allowed no empty name or value",
                         help_hint(app));
    }
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const std::string option = words[i], value = words[i + 1];
        if (option == "--") return;  // none of what follows is an option
        if (!is_option(option, commands, true)) continue;
        if (!value.starts_with("--") && !is_option(value, commands)) continue;
        throw InputError(option + " needs a value, and '" + shortened(value) + "' is an option: say " + option + "=" +
                             shortened(value) + " if it is meant",
                         help_hint(app));
    }
}

/// Parses a command line; `--help` and `--version` print their text.
/// @return false if a text was printed and there is nothing more to do
/// @throws InputError that names the option, the value and what is accepted
inline bool parse_command_line(CLI::App& app, int argc, char** argv) {
    app.set_version_flag("--version", app.get_name() + " " + DRAPE_VERSION);
    check_values(app, {argv, static_cast<std::size_t>(argc)});
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::Success& text) {
        app.exit(text);
        return false;
    } catch (const CLI::ParseError& error) {
        throw InputError(command_line_fault(app, error), help_hint(app));
    }
}

}  // namespace drape
