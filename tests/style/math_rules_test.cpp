#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <string_view>

#include "support/process.h"
#include "support/scratch_folder.h"

namespace drape::style {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> math_layers{"base", "model", "integrate", "bounds", "contact", "sim", "lab"};

/// Of the C library, without the f or l at the end for the type. A fused multiply-add is exact, but is as slow as a
/// call where the processor lacks it.
const std::string open_functions =
    "(?:a?(?:sin|cos|tan)h?|atan2|sincos|exp(?:2|10|m1)?|log(?:2|10|1p)?|pow|cbrt|hypot|erfc?|[lt]gamma|j[01n]|y[01n]|"
    "fma)";

/// Names that compiled code may ask for, and why.
struct Exception {
    std::string_view object, name;
};
constexpr std::array<Exception, 1> exceptions{{{"scene.cpp.o", "log10"}}};  // toml++, for the width of a line

/// A line without its comment and without what stands between quotes.
std::string code_of(const std::string& line) {
    static const std::regex quoted(R"("(\\.|[^"\\])*")");
    const std::string bare = std::regex_replace(line, quoted, "\"\"");
    return bare.substr(0, bare.find("//"));
}

void check_file(const fs::path& file, std::vector<std::string>& offences) {
    static const std::regex call("(^|[^A-Za-z0-9_])(" + open_functions + "[fl]?)\\s*\\(");
    static const std::regex other(
        "\\b(\\w+_distribution|generate_canonical|random_device|shuffle|AngleAxis\\w*|computeDirect|eulerAngles)\\b");
    std::ifstream in(file);
    std::smatch match;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::string code = code_of(line);
        if (std::regex_search(code, match, call) || std::regex_search(code, match, other)) {
            offences.push_back(file.string() + ":" + std::to_string(number) + ": other bits elsewhere: " + line);
        }
    }
}

/// Finds the calls, in the sources under `root` of the layers that decide a state, a report or a table, of functions
/// whose bits the standards leave open: those of the C library but for the exact ones (square root, rounding,
/// remainder, scaling), the distributions of the standard library, and what of Eigen rests on either. Files whose name
/// ends in `_charts.cpp` draw.
std::vector<std::string> check_math(const fs::path& root) {
    std::vector<std::string> offences;
    for (const fs::path& top : {root / "include" / "drape", root / "src"}) {
        for (const std::string_view layer : math_layers) {
            if (!fs::exists(top / layer)) continue;
            for (const auto& entry : fs::recursive_directory_iterator(top / layer)) {
                const std::string kind = entry.path().extension().string();
                const bool draws = entry.path().filename().string().ends_with("_charts.cpp");
                if ((kind == ".h" || kind == ".cpp") && !draws) check_file(entry.path(), offences);
            }
        }
    }
    return offences;
}

/// Finds the same among the names that compiled code asks for, whatever header they come from.
/// @param listing what `nm -u` prints of a library
std::vector<std::string> check_symbols(const std::string& listing) {
    static const std::regex member(R"((\S+\.o):)"),
        wanted("\\s*U (?:__)?(" + open_functions + "[fl]?)(?:_finite)?(@.*)?");
    std::vector<std::string> offences;
    std::istringstream in(listing);
    std::smatch match;
    std::string object;
    for (std::string line; std::getline(in, line);) {
        if (std::regex_match(line, match, member)) object = match[1];
        if (!std::regex_match(line, match, wanted)) continue;
        const bool excused = std::ranges::any_of(exceptions, [&](const Exception& exception) {
            return exception.object == object && exception.name == match[1].str();
        });
        if (!excused) offences.push_back(object + ": " + match[1].str() + " has other bits elsewhere");
    }
    return offences;
}

/// What `nm -u` prints of the library that simulates.
std::string names_that_the_core_asks_for() {
    const ScratchFolder folder;
    test::Process lister({NAME_LISTER, "-u", DRAPE_CORE, DRAPE_CORE_LIGHT}, {}, folder.path());
    EXPECT_EQ(lister.wait_to_end(), 0);
    return lister.standard_output();
}

/// What is wrong with one line of a file of a layer; empty if nothing.
std::string verdict(const std::string& line, const std::string& file = "src/sim/a.cpp") {
    const ScratchFolder root;
    fs::create_directories((root.path() / file).parent_path());
    std::ofstream(root.path() / file) << line << "\n";
    const std::vector<std::string> offences = check_math(root.path());
    return offences.empty() ? "" : offences.front();
}

TEST(MathRules, HoldInThisRepository) {
    for (const std::string& offence : check_math(DRAPE_SOURCE_DIR)) ADD_FAILURE() << offence;
}

TEST(MathRules, HoldInTheCompiledCoreWithAllItsHeaders) {
    const std::string listing = names_that_the_core_asks_for();
    EXPECT_NE(listing.find("scene.cpp.o"), std::string::npos) << "that is no listing";
    for (const std::string& offence : check_symbols(listing)) ADD_FAILURE() << offence;
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
