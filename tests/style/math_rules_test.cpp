#include "math_rules.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/process.h"
#include "support/scratch_folder.h"

namespace drape::style {
namespace {

/// What `nm -u` prints of the library that simulates.
std::string names_that_the_core_asks_for() {
    const ScratchFolder folder;
    test::Process lister({NAME_LISTER, "-u", DRAPE_CORE}, {}, folder.path());
    EXPECT_EQ(lister.wait_to_end(), 0);
    return lister.standard_output();
}

/// What is wrong with one line of a file of a layer; empty if nothing.
std::string verdict(const std::string& line, const std::string& file = "src/sim/a.cpp") {
    const ScratchFolder root;
    std::filesystem::create_directories((root.path() / file).parent_path());
    std::ofstream(root.path() / file) << line << "\n";
    const std::vector<Offence> offences = check_math(root.path());
    return offences.empty() ? "" : offences.front().text;
}

TEST(MathRules, HoldInThisRepository) {
    for (const Offence& offence : check_math(DRAPE_SOURCE_DIR)) {
        ADD_FAILURE() << offence.file << ":" << offence.line << ": " << offence.text;
    }
}

TEST(MathRules, HoldInTheCompiledCoreWithAllItsHeaders) {
    const std::string listing = names_that_the_core_asks_for();
    EXPECT_NE(listing.find("scene.cpp.o"), std::string::npos) << "that is no listing";
    for (const Offence& offence : check_symbols(listing)) ADD_FAILURE() << offence.file << ": " << offence.text;
}

TEST(MathRules, FindACallWhoseBitsAreOpen) {
    for (const char* line :
         {"x = std::sin(y);", "x = sinf (y);", "return 2*exp(-t);", "std::pow(x, 2)", "std::hypot(a, b)",
          "v.array().sin()", "x = log1p(y);", "std::normal_distribution<Real> draw;", "std::fma(a, b, c)",
          "using std::cos; y = cos(x);", "std::shuffle(a, b, random);"}) {
        EXPECT_NE(verdict(line), "") << line;
    }
    EXPECT_NE(verdict("std::log(x)", "include/drape/base/a.h"), "");
    EXPECT_NE(verdict("std::log(x)", "src/lab/measure/a.cpp"), "");
}

TEST(MathRules, LetExactFunctionsAndOtherNamesBe) {
    for (const char* line : {"std::sqrt(x)", "std::floor(x) + std::fmod(x, 2)", "std::ldexp(x, 3)", "sine(x)",
                             "natural_log(x)", "exponential(x)", "tangent(path, k)", "// sin(x) is meant",
                             "throw InputError(\"log(x)\");", "catalog(x)", "std::abs(x)", "longest_step(x)"}) {
        EXPECT_EQ(verdict(line), "") << line;
    }
    EXPECT_EQ(verdict("std::sin(x)", "src/render/a.cpp"), "") << "a picture";
    EXPECT_EQ(verdict("std::log10(x)", "src/lab/precision/precision_charts.cpp"), "") << "a chart";
}

TEST(MathRules, FindASymbolWhoseBitsAreOpen) {
    EXPECT_TRUE(check_symbols("\na.cpp.o:\n                 U floor\n                 U _ZN5drape4sineEd\n").empty());
    for (const char* name : {"sin", "sinf", "expm1", "pow@GLIBC_2.29", "logl", "__exp_finite"}) {
        EXPECT_EQ(check_symbols(std::string("\na.cpp.o:\n                 U ") + name + "\n").size(), 1u) << name;
    }
}

}  // namespace
}  // namespace drape::style
