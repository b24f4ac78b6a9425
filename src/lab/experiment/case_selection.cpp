#include "case_selection.h"

#include <algorithm>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "share.h"

namespace drape {
namespace {

constexpr std::string_view cases_word = " --cases ", share_word = " --share ";

/// Takes what follows a word up to the next blank off the front of a text; empty if the word is not there.
std::string taken(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return "";
    const std::size_t end = std::min(text.find(' ', word.size()), text.size());
    const std::string value(text.substr(word.size(), end - word.size()));
    text.remove_prefix(end);
    return value;
}

}  // namespace

std::string CaseSelection::text() const {
    std::string all = quick ? "--quick" : "whole";
    if (!cases.empty()) all += std::string(cases_word) + cases;
    if (!share.empty()) all += std::string(share_word) + share;
    return all;
}

std::vector<std::size_t> CaseSelection::numbers(std::size_t count) const {
    std::size_t first = 1, last = count;
    if (!cases.empty()) {
        const std::size_t dash = std::min(cases.find('-'), cases.size());
        const auto from = parse_integer(std::string_view(cases).substr(0, dash));
        const auto to = parse_integer(std::string_view(cases).substr(std::min(dash + 1, cases.size())));
        if (!from || !to || !(*from >= 1 && *from <= *to && *to <= static_cast<long long>(count))) {
            throw InputError("--cases " + shortened(cases) +
                             ": allowed FIRST-LAST with 1 <= FIRST <= LAST <= " + std::to_string(count));
        }
        first = static_cast<std::size_t>(*from);
        last = static_cast<std::size_t>(*to);
    }
    const Share part = parse_share(share);
    std::vector<std::size_t> wanted;
    for (std::size_t number = first; number <= last; ++number) {
        if (part.has(number)) wanted.push_back(number);
    }
    return wanted;
}

std::optional<CaseSelection> parse_selection(const std::string& text) {
    std::string_view rest = text;
    CaseSelection selection;
    selection.quick = rest.starts_with("--quick");
    if (!selection.quick && !rest.starts_with("whole")) return {};
    rest.remove_prefix(selection.quick ? std::string_view("--quick").size() : std::string_view("whole").size());
    selection.cases = taken(rest, cases_word);
    selection.share = taken(rest, share_word);
    if (selection.text() != text) return {};
    return selection;
}

}  // namespace drape
