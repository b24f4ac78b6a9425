#pragma once

#include <algorithm>
#include <random>
#include <type_traits>

namespace drape {

/// The next number of an even distribution in [-1, 1). The generator's bits are fixed by the standard; those of the
/// standard library's distributions are not.
/// @tparam Number float takes one draw of 32 bits, double two
template <class Number>
Number draw_even(std::mt19937& random) {
    if constexpr (std::is_same_v<Number, float>) {
        return 2 * std::min(static_cast<float>(random()) * 0x1p-32f, 0x1.fffffep-1f) - 1;
    } else {
        const auto low = static_cast<double>(random()), high = static_cast<double>(random());
        return 2 * std::min((low + high * 0x1p32) * 0x1p-64, 0x1.fffffffffffffp-1) - 1;
    }
}

}  // namespace drape
