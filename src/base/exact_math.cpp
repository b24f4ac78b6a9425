#include "drape/base/exact_math.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape {
namespace {

/// A number as a sum of two, the second less than the last bit of the first.
struct Sum {
    double head, tail;
};

/// a + b without error. @cite knuth1997
Sum exact_sum(double a, double b) {
    const double head = a + b, b_part = head - a;
    return {head, (a - (head - b_part)) + (b - b_part)};
}

/// pi/2 in parts of at most 30 bits but for the last, so that their products with integers up to 2^23 are exact.
constexpr std::array<double, 4> quarter_turn{0x1.921fb54p+0, 0x1.10b46118p-30, 0x1.313198ap-61, 0x1.701b839a25205p-92};
constexpr double longest_reduction = 1.3e7;  // 2^23 quarters

/// x - n pi/2. @cite cody1980
Sum less_quarter_turns(double x, double n) {
    Sum rest{x, 0};
    for (const double part : quarter_turn) {
        const Sum next = exact_sum(rest.head, -n * part);
        rest = {next.head, next.tail + rest.tail};
    }
    return exact_sum(rest.head, rest.tail);
}

/// sin(r) = r - r^3/3! + ... - r^19/19! for |r| <= pi/4.
double sine_near_zero(Sum r) {
    const double z = r.head * r.head;
    double series = 0;
    for (int n = 19; n >= 3; n -= 2) series = (1 - z * series) / ((n - 1) * n);
    return r.head - (r.head * z * series - r.tail * (1 - z / 2));
}

/// cos(r) = 1 - r^2/2! + ... - r^18/18! for |r| <= pi/4.
double cosine_near_zero(Sum r) {
    const double z = r.head * r.head, half = z / 2, most = 1 - half;
    double series = 0;
    for (int n = 18; n >= 4; n -= 2) series = (1 - z * series) / ((n - 1) * n);
    return most + (((1 - most) - half) + (half * z * series - r.head * r.tail));
}

/// ln 2 in two parts, the first of 40 bits: its products with binary exponents are exact.
constexpr double log_two_head = 0x1.62e42fefa2p-1, log_two_tail = 0x1.9ef35793c7673p-41;

}  // namespace

double sine(double x) {
    constexpr double pi = std::numbers::pi;
    if (std::abs(x) > longest_reduction) x = std::fmod(x, 2 * pi);  // exact but for the rounding of pi
    if (!std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
    const double n = std::round(x * (2 / pi));
    const Sum r = less_quarter_turns(x, n);
    const int quarter = static_cast<int>(n) & 3;
    const double size = quarter % 2 == 0 ? sine_near_zero(r) : cosine_near_zero(r);
    return quarter < 2 ? size : -size;
}

double natural_log(double x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (x == 0) return -infinity;
    if (!(x > 0 && x < infinity)) return x > 0 ? x : std::numeric_limits<double>::quiet_NaN();
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < std::numbers::sqrt2 / 2) mantissa *= 2, --exponent;

    // ln(1 + f) = 2 atanh(s) = f - f^2/2 + s (f^2/2 + 2 s^2/3 + 2 s^4/5 + ...) with s = f / (2 + f)
    const double f = mantissa - 1, s = f / (2 + f), z = s * s, half = f * f / 2;
    double series = 0;
    for (int n = 23; n >= 3; n -= 2) series = z * (2.0 / n + series);
    return exponent * log_two_head - ((half - (s * (half + series) + exponent * log_two_tail)) - f);
}

double exponential(double x) {
    if (std::isnan(x)) return x;
    x = std::clamp(x, -1000.0, 1000.0);  // long since zero and infinite
    const double n = std::round(x / std::numbers::ln2), head = x - n * log_two_head, tail = n * log_two_tail;
    const double r = head - tail, rest = (head - r) - tail;
    double series = 0;
    for (int k = 14; k >= 3; --k) series = r / k * (1 + series);
    return std::ldexp(1 + (r + (rest + r * r / 2 * (1 + series))), static_cast<int>(n));
}

}  // namespace drape
