#include "drape/base/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>

#include "drape/base/commit.h"
#include "drape/base/input_error.h"

namespace drape {
namespace {

void describe(CLI::Option* option, const OptionValue& value) {
    if (!value.name.empty()) option->type_name(value.name);
    if (value.required) option->required();
    if (!value.allowed.empty()) option->check(CLI::IsMember(value.allowed));
}

/// What is wrong with a command line: first of all a word that nothing expects, with the nearest one that is known.
std::string fault_of(const CLI::App& app, const CLI::ParseError& error) {
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
    return "unexpected '" + shortened(word) + "'" + did_you_mean(word, known);
}

/// Whether a word is an option of one of these: "--out", or "-h".
bool is_option(const std::string& word, std::span<const CLI::App* const> commands, bool with_value = false) {
    return std::ranges::any_of(commands, [&](const CLI::App* command) {
        const CLI::Option* option = word.starts_with('-') ? command->get_option_no_throw(word) : nullptr;
        return option != nullptr && !(with_value && option->get_items_expected_max() == 0);
    });
}

/// Refuses an option where another one's value should be, which the parser would take for the value; and empty words,
/// which would be taken for what was not given: a shell makes one of a variable that is not set.
void check_values(const CLI::App& app, std::span<char* const> words, const std::string& hint) {
    std::vector<const CLI::App*> commands = app.get_subcommands([](const CLI::App*) { return true; });
    commands.push_back(&app);
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string word = words[i], before = words[i - 1];
        const bool is_bare =
            word.starts_with("--") && word.ends_with('=') && is_option(word.substr(0, word.size() - 1), commands, true);
        if (!word.empty() && !is_bare) continue;
        const std::string option = is_bare ? word.substr(0, word.size() - 1) : before;
        throw InputError(
            (is_option(option, commands, true) ? option + " has no value" : "word " + std::to_string(i) + " is empty") +
                ": allowed no empty name or value",
            hint);
    }
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const std::string option = words[i], value = words[i + 1];
        if (option == "--") return;  // none of what follows is an option
        if (!is_option(option, commands, true)) continue;
        if (!value.starts_with("--") && !is_option(value, commands)) continue;
        throw InputError(option + " needs a value, and '" + shortened(value) + "' is an option: say " + option + "=" +
                             shortened(value) + " if it is meant",
                         hint);
    }
}

}  // namespace

CommandLine::CommandLine(const std::string& program, const std::string& description)
    : program_(std::make_unique<CLI::App>(description, program)), app_(program_.get()) {}
CommandLine::CommandLine(CLI::App* command) : app_(command) {}
CommandLine::~CommandLine() = default;

void CommandLine::option(const std::string& option, std::string& to, const std::string& help,
                         const OptionValue& value) {
    describe(app_->add_option(option, to, help), value);
}
void CommandLine::option(const std::string& option, std::vector<std::string>& to, const std::string& help,
                         const OptionValue& value) {
    describe(app_->add_option(option, to, help), value);
}

void CommandLine::flag(const std::string& flag, bool& to, const std::string& help, const std::string& excludes) {
    CLI::Option* const option = app_->add_flag(flag, to, help);
    if (!excludes.empty()) option->excludes(app_->get_option(excludes));
}

void CommandLine::footer(std::function<std::string()> text) { app_->footer(std::move(text)); }

CommandLine& CommandLine::command(const std::string& name, const std::string& description, std::function<void()> run) {
    app_->require_subcommand(1);
    CLI::App* const command = app_->add_subcommand(name, description);
    if (run) command->callback(std::move(run));
    commands_.push_back(std::unique_ptr<CommandLine>(new CommandLine(command)));
    return *commands_.back();
}

bool CommandLine::parse(int argc, char** argv) {
    app_->set_version_flag(
        "--version", app_->get_name() + " " + DRAPE_VERSION + ", commit " + commit() + "\nBuilt from " + libraries());
    check_values(*app_, {argv, static_cast<std::size_t>(argc)}, help_hint());
    try {
        app_->parse(argc, argv);
        return true;
    } catch (const CLI::Success& text) {
        app_->exit(text);
        return false;
    } catch (const CLI::ParseError& error) {
        throw InputError(fault_of(*app_, error), help_hint());
    }
}

std::string CommandLine::help_hint() const { return "See " + app_->get_name() + " --help."; }

}  // namespace drape
