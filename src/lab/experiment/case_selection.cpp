#include "case_selection.h"

#include <fmt/core.h>

#include <regex>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr std::size_t most_parts = 10000;

/// Two numbers with a mark between.
/// @throws InputError unless 1 <= first <= second <= most
std::pair<std::size_t, std::size_t> parse_pair(const std::string& text, char mark, std::size_t most,
                                               const std::string& option, const char* first, const char* second) {
    const auto pair = parse_integers(text, mark);
    if (pair && pair->first >= 1 && pair->first <= pair->second && pair->second <= static_cast<long long>(most)) {
        return *pair;
    }
    throw InputError(fmt::format("{} {}: allowed {}{}{} with 1 <= {} <= {} <= {}", option, shortened(text), first, mark,
                                 second, first, second, most));
}

}  // namespace

std::string CaseSelection::text() const {
    std::string all = quick ? "--quick" : "whole";
    if (!cases.empty()) all += " --cases " + cases;
    if (!share.empty()) all += " --share " + share;
    return all;
}

std::vector<std::size_t> CaseSelection::numbers(std::size_t count) const {
    const auto range =
        parse_pair(cases.empty() ? fmt::format("1-{}", count) : cases, '-', count, "--cases", "FIRST", "LAST");
    const auto part = parse_pair(share.empty() ? "1/1" : share, '/', most_parts, "--share", "K", "N");
    std::vector<std::size_t> wanted;
    for (std::size_t number = range.first; number <= range.second; ++number) {
        if (number % part.second == part.first % part.second) wanted.push_back(number);
    }
    return wanted;
}

std::optional<CaseSelection> parse_selection(const std::string& text) {
    static const std::regex form("(--quick|whole)(?: --cases ([^ ]+))?(?: --share ([^ ]+))?");
    std::smatch parts;
    // The matcher's depth is that of the text
    if (text.size() > 1000 || !std::regex_match(text, parts, form)) return {};
    return CaseSelection{parts[1] == "--quick", parts[2], parts[3]};
}

}  // namespace drape
