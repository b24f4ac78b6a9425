#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drape {

/// Which cases of an experiment a run computes, as its options say it and its table's head.
struct CaseSelection {
    bool quick = false;
    std::string cases = {};  ///< "FIRST-LAST"; empty for all
    std::string share = {};  ///< "K/N", the K-th of N parts: K, K + N, K + 2N, ...; empty for all

    /// "--quick --cases 3-7 --share 1/2", or "whole" in place of "--quick".
    [[nodiscard]] std::string text() const;

    /// The numbers of the cases, ascending from 1.
    /// @param count of all cases that there are
    /// @throws InputError that names the option if a part of it is none
    [[nodiscard]] std::vector<std::size_t> numbers(std::size_t count) const;
};

/// Reads what `text` has written; nothing if it is anything else. What the options say is not looked at.
std::optional<CaseSelection> parse_selection(const std::string& text);

}  // namespace drape
