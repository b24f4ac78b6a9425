#include "case_selection.h"

#include <fmt/core.h>

#include <regex>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

/// The numbers of "FROM<between>TO" if 1 <= FROM <= TO <= most.
std::optional<std::pair<std::size_t, std::size_t>> parse_pair(std::string_view text, char between, std::size_t most) {
    const auto pair = parse_integers(text, between);
    if (!pair || !(pair->first >= 1 && pair->first <= pair->second && pair->second <= static_cast<long long>(most))) {
        return {};
    }
    return std::pair(static_cast<std::size_t>(pair->first), static_cast<std::size_t>(pair->second));
}

}  // namespace

Share parse_share(const std::string& text) {
    constexpr std::size_t most = 10000;
    if (text.empty()) return {};
    const auto share = parse_pair(text, '/', most);
    if (!share) throw InputError(fmt::format("--share {}: allowed K/N with 1 <= K <= N <= {}", shortened(text), most));
    return {share->first, share->second};
}

std::string CaseSelection::text() const {
    std::string all = quick ? "--quick" : "whole";
    if (!cases.empty()) all += " --cases " + cases;
    if (!share.empty()) all += " --share " + share;
    return all;
}

std::vector<std::size_t> CaseSelection::numbers(std::size_t count) const {
    const auto range = cases.empty() ? std::optional(std::pair(std::size_t{1}, count)) : parse_pair(cases, '-', count);
    if (!range) {
        throw InputError(
            fmt::format("--cases {}: allowed FIRST-LAST with 1 <= FIRST <= LAST <= {}", shortened(cases), count));
    }
    const Share part = parse_share(share);
    std::vector<std::size_t> wanted;
    for (std::size_t number = range->first; number <= range->second; ++number) {
        if (part.has(number)) wanted.push_back(number);
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
