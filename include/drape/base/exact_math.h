#pragma once

#include <algorithm>
#include <random>
#include <type_traits>

namespace drape {

/// The functions below give the same bits on every processor and with every C library. Those of the C library do not:
/// the standard leaves their last bit open, and glibc takes another variant where a processor has fused multiply-add.
/// These consist of + - * / alone, whose bits IEEE 754 fixes, and of steps that are exact. Whatever decides a state, a
/// report or a table calls these; a test searches the sources for any other.
///
/// Each is the Taylor series about the nearest point where the value is known. Errors are in units in the last place of
/// the result (ulp).

/// sin(x), to 1 ulp for |x| <= 1e7. Beyond, the error stays below what the rounding of x itself makes.
/// @param x [rad]
double sine(double x);

/// The natural logarithm, to 1 ulp; of 0 it is -infinity, of less not a number.
double natural_log(double x);

/// e^x, to 1 ulp where the result is a normal number.
double exponential(double x);

/// The next number of an even distribution in [-1, 1). The generator's bits are fixed by the standard; those of the
/// standard library's distributions are not.
/// @tparam Number float takes one draw of 32 bits, double two
template <class Number>
Number uniform(std::mt19937& random) {
    if constexpr (std::is_same_v<Number, float>) {
        return 2 * std::min(static_cast<float>(random()) * 0x1p-32f, 0x1.fffffep-1f) - 1;
    } else {
        const auto low = static_cast<double>(random()), high = static_cast<double>(random());
        return 2 * std::min((low + high * 0x1p32) * 0x1p-64, 0x1.fffffffffffffp-1) - 1;
    }
}

}  // namespace drape
