#include "drape/base/program.h"

#include <gmock/gmock.h>

#include <fstream>

namespace drape {
namespace {

using testing::HasSubstr;

/// A program with one subcommand and one required option, told `words`; returns what it complains about.
std::string complaint(std::vector<std::string> words) {
    CLI::App app("A program of the tests.", "program");
    app.require_subcommand(1);
    std::string time;
    app.add_subcommand("simulate")->add_option("--time", time)->required();
    app.add_subcommand("collide");
    words.insert(words.begin(), "program");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    try {
        parse_command_line(app, static_cast<int>(argv.size()), argv.data());
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// The exit code and the standard error of a program that does `run`.
std::pair<int, std::string> outcome(int (*run)(int, char**)) {
    testing::internal::CaptureStderr();
    const int code = run_program("program", 0, nullptr, run);
    return {code, testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, IsAcceptedWhenWhole) { EXPECT_EQ(complaint({"simulate", "--time", "1"}), ""); }

TEST(CommandLine, NamesTheNearestSubcommand) {
    EXPECT_THAT(complaint({"simulat"}), HasSubstr("unexpected 'simulat': did you mean 'simulate'?"));
}

TEST(CommandLine, NamesTheNearestOptionRatherThanTheOneMissing) {
    EXPECT_THAT(complaint({"simulate", "--tme", "1"}), HasSubstr("unexpected '--tme': did you mean '--time'?"));
}

TEST(CommandLine, NamesAWordTooMany) {
    EXPECT_THAT(complaint({"simulate", "--time", "1", "more"}), HasSubstr("unexpected 'more'\n"));
}

TEST(CommandLine, NamesWhatIsMissing) {
    EXPECT_THAT(complaint({"simulate"}), HasSubstr("--time is required"));
    EXPECT_THAT(complaint({}), HasSubstr("subcommand is required"));
}

TEST(Program, ReturnsTheExitCodeOfItsRun) {
    EXPECT_EQ(outcome([](int, char**) { return 143; }), std::pair(143, std::string()));
}

TEST(Program, TellsBadInputFromAFailedRun) {
    EXPECT_EQ(outcome([](int, char**) -> int { throw InputError("no"); }), std::pair(2, std::string("program: no\n")));
    EXPECT_EQ(outcome([](int, char**) -> int { throw RunError("no"); }), std::pair(1, std::string("program: no\n")));
    EXPECT_EQ(outcome([](int, char**) -> int { throw std::bad_alloc(); }).first, 1);
}

TEST(Program, PrintsNoControlCharactersOfItsInput) {
    const auto [code, text] = outcome([](int, char**) -> int { throw InputError("key '\x1b[31m'\nSee --help."); });
    EXPECT_EQ(text, "program: key '?[31m'\nSee --help.\n");
}

TEST(Program, FailsIfItsOutputCannotBeWritten) {
    std::ofstream full("/dev/full");
    std::streambuf* const before = std::cout.rdbuf(full.rdbuf());
    const auto [code, text] = outcome([](int, char**) {
        std::cout << "0123456789abcdef\n";
        return 0;
    });
    std::cout.rdbuf(before);
    std::cout.clear();
    EXPECT_EQ(code, 1);
    EXPECT_THAT(text, HasSubstr("standard output could not be written"));
}

}  // namespace
}  // namespace drape
