#pragma once

#include <cmath>
#include <complex>

namespace drape {

inline double longest_step_of_explicit_euler(double k, double d) {
    return d * d <= 4 * k ? d / k : 4 / (d + std::sqrt(d * d - 4 * k));
}

inline double longest_step_of_symplectic_euler(double k, double d) { return 4 / (d + std::sqrt(d * d + 4 * k)); }

/// A factor of -1 at h^2 k + 2 h d - h^2 d^2 = 4, or one of 1 at h d = 2.
inline double longest_step_of_velocity_verlet(double k, double d) {
    return k >= d * d ? 4 / (d + std::sqrt(4 * k - 3 * d * d)) : 2 / d;
}

/// Where |R(h lambda)| reaches 1, for the faster root lambda of lambda^2 + d lambda + k = 0.
inline double longest_step_of_rk4(double k, double d) {
    using Complex = std::complex<double>;
    constexpr double rounding = 1e-12;
    const double root = d * d - 4 * k;
    const Complex lambda = root > 0 ? Complex(-(d + std::sqrt(root)) / 2, 0) : Complex(-d / 2, std::sqrt(-root) / 2);
    double stable = 0, unstable = 4 / std::sqrt(std::norm(lambda));  // it does not reach three
    for (int bisection = 0; bisection < 50; ++bisection) {
        const double middle = (stable + unstable) / 2;
        const Complex z = middle * lambda, factor = 1. + z * (1. + z / 2. * (1. + z / 3. * (1. + z / 4.)));
        (std::norm(factor) <= 1 + rounding ? stable : unstable) = middle;
    }
    return stable;
}

}  // namespace drape
