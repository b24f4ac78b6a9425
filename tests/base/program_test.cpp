#include "drape/base/command_line.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iostream>

#include "drape/base/input_error.h"
#include "drape/base/run_program.h"

namespace drape {
namespace {

using testing::HasSubstr;

/// A program with one subcommand and one required option, told `words`; returns what it complains about.
std::string complaint(std::vector<std::string> words) {
    CommandLine line("program", "A program of the tests.");
    std::string time, scene, ball;
    std::vector<std::string> sets;
    bool quick = false;
    CommandLine& simulate = line.command("simulate", "");
    simulate.option("scene", scene, "");
    simulate.option("--time", time, "", {"T", true});
    simulate.option("--set", sets, "");
    simulate.flag("-q,--quick", quick, "");
    line.command("collide", "").option("--ball", ball, "");
    words.insert(words.begin(), "program");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    try {
        line.parse(static_cast<int>(argv.size()), argv.data());
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

TEST(CommandLine, NamesTheNearestOfWhatIsMeantAndWhatIsMissing) {
    EXPECT_EQ(complaint({"simulate", "--time", "1"}), "");
    EXPECT_THAT(complaint({"simulat"}), HasSubstr("unexpected 'simulat': did you mean 'simulate'?"));
    EXPECT_THAT(complaint({"simulate", "--tme", "1"}), HasSubstr("unexpected '--tme': did you mean '--time'?"));
    EXPECT_THAT(complaint({"simulate", "--time", "1", "drop", "more"}), HasSubstr("unexpected 'more'\n"));
    EXPECT_THAT(complaint({"simulate"}), HasSubstr("--time is required"));
    EXPECT_THAT(complaint({}), HasSubstr("subcommand is required"));
}

TEST(CommandLine, RefusesAnOptionInThePlaceOfAValue) {
    EXPECT_EQ(
        complaint({"simulate", "--time", "--quick"}),
        "--time needs a value, and '--quick' is an option: say --time=--quick if it is meant\nSee program --help.");
    EXPECT_THAT(complaint({"simulate", "--time", "--unknown"}), HasSubstr("--time needs a value"));
    EXPECT_THAT(complaint({"simulate", "--time", "-q"}), HasSubstr("--time needs a value, and '-q'"));
    EXPECT_THAT(complaint({"simulate", "--time", "--", "x"}), HasSubstr("--time needs a value"));
    EXPECT_THAT(complaint({"simulate", "--set", "--time", "1"}), HasSubstr("--set needs a value, and '--time'"));
    EXPECT_THAT(complaint({"collide", "--ball", "--help"}), HasSubstr("--ball needs a value"));
}

TEST(CommandLine, RefusesEmptyWords) {
    EXPECT_THAT(complaint({"simulate", "", "--time", "1"}), HasSubstr("word 2 is empty: allowed no empty"));
    EXPECT_THAT(complaint({"simulate", "--time", ""}), HasSubstr("--time has no value"));
    EXPECT_THAT(complaint({"simulate", "--time="}), HasSubstr("--time has no value"));
    EXPECT_EQ(complaint({"simulate", "--time", "1", "--set", "title="}), "");
}

TEST(CommandLine, TakesValuesThatOnlyLookLikeOptions) {
    EXPECT_EQ(complaint({"collide", "--ball", "-1,0,0,1"}), "");
    EXPECT_EQ(complaint({"collide", "--ball=--quick"}), "") << "said in one word";
    EXPECT_EQ(complaint({"collide", "--ball", "./--quick"}), "");
    EXPECT_EQ(complaint({"simulate", "--set", "a=1", "b=-2", "--quick", "--time", "1"}), "");
    EXPECT_EQ(complaint({"simulate", "--quick", "--time", "1"}), "") << "a flag has no value";
    EXPECT_EQ(complaint({"simulate", "--time", "1", "--", "--time"}), "") << "after -- all is the scene";
}

TEST(Program, TellsBadInputFromAFailedRun) {
    EXPECT_EQ(outcome([](int, char**) { return 143; }), std::pair(143, std::string()));
    EXPECT_EQ(outcome([](int, char**) -> int { throw InputError("no"); }), std::pair(2, std::string("program: no\n")));
    EXPECT_EQ(outcome([](int, char**) -> int { throw RunError("no"); }), std::pair(1, std::string("program: no\n")));
    EXPECT_EQ(outcome([](int, char**) -> int { throw std::bad_alloc(); }).first, 1);
}

TEST(Program, PrintsNoControlCharactersOfItsInput) {
    EXPECT_EQ(outcome([](int, char**) -> int { throw InputError("key '\x1b[31m'", "See --help."); }).second,
              "program: key '\\x1b[31m'\nSee --help.\n");
    EXPECT_EQ(outcome([](int, char**) -> int { throw RunError("one\n\x1b[31mtwo"); }).second,
              "program: one\\n\\x1b[31mtwo\n");
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
