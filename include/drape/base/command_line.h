#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace drape {

/// What an option takes, and whether it must be there.
struct OptionValue {
    std::string name = "";  ///< as `--help` shows it: "FILE.csv"
    bool required = false;
    std::vector<std::string> allowed = {};  ///< empty: anything
};

/// The options of a program or of one of its commands, each of which fills a variable. CLI11 reads them; its header,
/// which takes longer to compile than most of Drape's files, is included in one place.
class CommandLine {
public:
    CommandLine(const std::string& program, const std::string& description);
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;
    ~CommandLine();

    /// Adds an option ("--out") or a positional argument ("scene").
    /// @param to outlives the parsing, and keeps its value where the option is not there
    void option(const std::string& option, std::string& to, const std::string& help, const OptionValue& value = {});
    void option(const std::string& option, std::vector<std::string>& to, const std::string& help,
                const OptionValue& value = {});

    /// Adds an option without a value.
    /// @param excludes another flag, declared before, that it cannot be combined with
    void flag(const std::string& flag, bool& to, const std::string& help, const std::string& excludes = "");

    /// What `--help` ends with.
    void footer(std::function<std::string()> text);

    /// Adds a command, one of which must be there.
    /// @param run called once the whole line is read
    /// @return the command's own options; it lives as long as this
    CommandLine& command(const std::string& name, const std::string& description, std::function<void()> run = {});

    /// Reads a command line; `--help` and `--version` print their text.
    /// @return false if a text was printed and there is nothing more to do
    /// @throws InputError that names the option, the value and what is accepted
    bool parse(int argc, char** argv);

    /// The second line of what is said of a bad command line.
    [[nodiscard]] std::string help_hint() const;

private:
    explicit CommandLine(CLI::App* command);

    std::unique_ptr<CLI::App> program_;  ///< none for a command
    CLI::App* app_;
    std::vector<std::unique_ptr<CommandLine>> commands_;
};

}  // namespace drape
