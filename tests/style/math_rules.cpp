#include "math_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <string_view>

namespace drape::style {

namespace fs = std::filesystem;

namespace {

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

void check_file(const fs::path& file, std::vector<Offence>& offences) {
    static const std::regex call("(^|[^A-Za-z0-9_])(" + open_functions + "[fl]?)\\s*\\(");
    static const std::regex other(
        "\\b(\\w+_distribution|generate_canonical|random_device|shuffle|AngleAxis\\w*|computeDirect|eulerAngles)\\b");
    std::ifstream in(file);
    std::smatch match;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::string code = code_of(line);
        if (std::regex_search(code, match, call)) {
            offences.push_back({file.string(), number, match[2].str() + " has other bits elsewhere"});
        } else if (std::regex_search(code, match, other)) {
            offences.push_back({file.string(), number, match[1].str() + " has other bits elsewhere"});
        }
    }
}

}  // namespace

std::vector<Offence> check_math(const fs::path& root) {
    std::vector<Offence> offences;
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

std::vector<Offence> check_symbols(const std::string& listing) {
    static const std::regex member(R"((\S+\.o):)"),
        wanted("\\s*U (?:__)?(" + open_functions + "[fl]?)(?:_finite)?(@.*)?");
    std::vector<Offence> offences;
    std::istringstream in(listing);
    std::smatch match;
    std::string object;
    for (std::string line; std::getline(in, line);) {
        if (std::regex_match(line, match, member)) object = match[1];
        if (!std::regex_match(line, match, wanted)) continue;
        const bool excused = std::ranges::any_of(exceptions, [&](const Exception& exception) {
            return exception.object == object && exception.name == match[1].str();
        });
        if (!excused) offences.push_back({object, 0, match[1].str() + " has other bits elsewhere"});
    }
    return offences;
}

}  // namespace drape::style
