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

/// What the product of coefficients i and j of polynomials with M and N of them adds to coefficient i + j.
template <std::size_t M, std::size_t N>
constexpr std::array<std::array<double, N>, M> product_weights() {
    std::array<std::array<double, N>, M> weights{};
    for (std::size_t i = 0; i < M; ++i) {
        for (std::size_t j = 0; j < N; ++j) {
            weights[i][j] = binomial(M - 1, i) * binomial(N - 1, j) / binomial(M + N - 2, i + j);
        }
    }
    return weights;
}

/// The polynomial `multiply(f(u), g(u))` for a product of numbers or vectors.
/// @param zero of its values
template <class F, class G, std::size_t M, std::size_t N, class Multiply, class Value>
std::array<Value, M + N - 1> product(const std::array<F, M>& f, const std::array<G, N>& g, Multiply multiply,
                                     const Value& zero) {
    static constexpr auto weights = product_weights<M, N>();
    std::array<Value, M + N - 1> h;
    h.fill(zero);
    for (std::size_t i = 0; i < M; ++i) {
        for (std::size_t j = 0; j < N; ++j) h[i + j] += weights[i][j] * multiply(f[i], g[j]);
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
/// @return the lower bound, which is early by the root of a digit at the most: what is done with it goes on from there
template <std::size_t Size>
double only_root(const std::array<double, Size>& f) {
    constexpr double narrow = 1e-8;
    constexpr int patience = 100;
    double low = 0, high = 1, at_low = f.front(), at_high = f.back();
    bool high_moved = false, low_moved = false;
    for (int k = 0; k < patience && high - low > narrow; ++k) {
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
    return low;
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
