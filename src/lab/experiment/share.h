#pragma once

#include <cstddef>
#include <string>

namespace drape {

/// The K-th of N parts of the cases: K, K + N, K + 2N, ...
struct Share {
    std::size_t part = 1, parts = 1;

    /// @param number of a case, from 1
    [[nodiscard]] bool has(std::size_t number) const { return number % parts == part % parts; }
};

/// @param text "K/N", or empty for all
/// @throws InputError unless 1 <= K <= N <= 10000
Share parse_share(const std::string& text);

}  // namespace drape
