#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

// Polynomials on [0, 1] by their Bernstein coefficients: f(u) = sum_i f_i C(n, i) u^i (1 - u)^(n - i), n + 1 of them
// for degree n. f lies between the smallest and the largest of them, is f_0 at 0 and f_n at 1, and is zero at most as
// often as their sign changes. @cite farouki2012

namespace drape::bernstein {

constexpr double binomial(std::size_t n, std::size_t k) {
    double value = 1;
    for (std::size_t i = 0; i < k; ++i) value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return value;
}

/// The polynomial `multiply(f(u), g(u))` for a product of numbers or vectors.
template <class F, class G, std::size_t M, std::size_t N, class Multiply>
auto product(const std::array<F, M>& f, const std::array<G, N>& g, Multiply multiply) {
    using Value = decltype(multiply(f[0], g[0]));
    std::array<Value, M + N - 1> h;
    for (std::size_t k = 0; k < h.size(); ++k) {
        const std::size_t first = k < N ? 0 : k - N + 1, last = std::min(k, M - 1);
        for (std::size_t i = first; i <= last; ++i) {
            const double weight = binomial(M - 1, i) * binomial(N - 1, k - i) / binomial(M + N - 2, k);
            const Value term = weight * multiply(f[i], g[k - i]);
            h[k] = i == first ? term : Value(h[k] + term);
        }
    }
    return h;
}

/// Both halves, each on [0, 1] again (de Casteljau).
template <std::size_t Size>
struct Halves {
    std::array<double, Size> left, right;
};

template <std::size_t Size>
Halves<Size> split_at(std::array<double, Size> f, double u) {
    Halves<Size> halves;
    for (std::size_t level = 0; level < Size; ++level) {
        halves.left[level] = f[0];
        halves.right[Size - 1 - level] = f[Size - 1 - level];
        for (std::size_t i = 0; i + level + 1 < Size; ++i) f[i] = (1 - u) * f[i] + u * f[i + 1];
    }
    return halves;
}

template <std::size_t Size>
double value_at(std::array<double, Size> f, double u) {
    for (std::size_t level = 1; level < Size; ++level) {
        for (std::size_t i = 0; i + level < Size; ++i) f[i] = (1 - u) * f[i] + u * f[i + 1];
    }
    return f[0];
}

/// The root of a polynomial that is positive at 0, not at 1, and has no other: by secants between two bounds, of which
/// one that stays is weighed down (Illinois). @cite dowell1971
/// @return the upper bound, where f <= 0
template <std::size_t Size>
double only_root(const std::array<double, Size>& f) {
    constexpr double narrow = 2 * std::numeric_limits<double>::epsilon();
    constexpr int patience = 100;
    double low = 0, high = 1, at_low = f.front(), at_high = f.back();
    bool high_moved = false, low_moved = false;
    for (int k = 0; k < patience && high - low > narrow * high && at_high < 0; ++k) {
        const double secant = low + (high - low) * (at_low / (at_low - at_high));
        const double u = secant > low && secant < high ? secant : (low + high) / 2;
        const double value = value_at(f, u);
        if (value > 0) {
            low = u, at_low = value;
            if (low_moved) at_high /= 2;
        } else {
            high = u, at_high = value;
            if (high_moved) at_low /= 2;
        }
        low_moved = value > 0, high_moved = !low_moved;
    }
    return high;
}

/// Calls visit(u) where f falls from above zero to zero or below, from left to right, until it returns true. A stretch
/// whose sign changes more than once is halved; one too narrow for that counts as one such fall. Zero counts as below,
/// so that a root between two halves is the left one's, and one at 1 is found; f <= 0 at 0 is no fall.
/// @return whether visit returned true
template <std::size_t Size, class Visit>
bool visit_falls(const std::array<double, Size>& f, Visit& visit, double begin = 0, double end = 1) {
    int changes = 0;
    for (std::size_t i = 1; i < Size; ++i) changes += (f[i] > 0) != (f[i - 1] > 0);
    if (changes == 0 || (changes == 1 && f.back() > 0)) return false;
    if (changes == 1) return visit(begin + (end - begin) * only_root(f));
    if (end - begin < 4 * std::numeric_limits<double>::epsilon()) return visit(end);
    const Halves<Size> halves = split_at(f, 0.5);
    const double middle = (begin + end) / 2;
    return visit_falls(halves.left, visit, begin, middle) || visit_falls(halves.right, visit, middle, end);
}

}  // namespace drape::bernstein
