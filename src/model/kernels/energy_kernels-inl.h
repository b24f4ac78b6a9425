#include "model/kernels/energy_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/kernels/axes.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Sums run in this many lanes; element i goes to lane i modulo it.
constexpr int sum_lanes = 8;

using Lanes = std::array<double, sum_lanes>;

HWY_INLINE double total(const Lanes& sums) {
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

/// @param values run_length of them, those from `count` on overwritten by zeros
HWY_INLINE void add_run(double* values, int count, Lanes& sums) {
    const int whole = (count + sum_lanes - 1) / sum_lanes * sum_lanes;
    for (int i = count; i < whole; ++i) values[i] = 0;
    for (int i = 0; i < whole; i += sum_lanes) {
        for (int lane = 0; lane < sum_lanes; ++lane) sums[static_cast<std::size_t>(lane)] += values[i + lane];
    }
}

/// Adds up p or its square, row by row.
template <bool squared>
HWY_INLINE double sum_of(const Real* p, const Grid& grid) {
    Lanes sums{};
    for (int j = 0; j < grid.ny; ++j) {
        const int first = grid.particle(0, j);
        for (int start = 0; start < grid.nx; start += run_length) {
            const int length = std::min(run_length, grid.nx - start);
            double values[run_length];
            for (int i = 0; i < length; ++i) {
                const double value = static_cast<double>(p[first + start + i]);
                values[i] = squared ? value * value : value;
            }
            add_run(values, length, sums);
        }
    }
    return total(sums);
}

ParticleSums sum_over_particles(const Grid& grid, const Points& positions, const Points& velocities) {
    const auto [x, y, z] = axes(positions);
    const auto [u, v, w] = axes(velocities);
    const auto squares = sum_of<true>(u, grid) + sum_of<true>(v, grid) + sum_of<true>(w, grid);
    return {{sum_of<false>(x, grid), sum_of<false>(y, grid), sum_of<false>(z, grid)}, squares};
}

SpringSums sum_over_springs(const SpringStencil& springs, const Grid& grid, const Points& positions,
                            const Points& velocities) {
    const auto [x, y, z] = axes(positions);
    const auto [u, v, w] = axes(velocities);
    const auto rest = static_cast<double>(springs.rest_length);
    const int count = springs.count(grid), offset = springs.offset(grid);
    Lanes elongations{}, speeds{};
    for (int j = 0; j < springs.rows(grid); ++j) {
        const int first = grid.particle(springs.first_column(), j);
        for (int start = 0; start < count; start += run_length) {
            const int length = std::min(run_length, count - start);
            double elongation[run_length], speed[run_length];
            for (int i = 0; i < length; ++i) {
                const int a = first + start + i, b = a + offset;
                const double dx = x[a] - x[b], dy = y[a] - y[b], dz = z[a] - z[b];
                const double ux = u[a] - u[b], uy = v[a] - v[b], uz = w[a] - w[b];
                const double square = dx * dx + dy * dy + dz * dz, along = dx * ux + dy * uy + dz * uz;
                const double longer = std::sqrt(square) - rest;
                elongation[i] = longer * longer;
                speed[i] = along * along / std::max(square, std::numeric_limits<double>::min());
            }
            add_run(elongation, length, elongations);
            add_run(speed, length, speeds);
        }
    }
    return {total(elongations), total(speeds)};
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sum_over_springs);
HWY_EXPORT(sum_over_particles);

SpringSums sum_over_springs(const SpringStencil& springs, const Grid& grid, const Points& x, const Points& v) {
    return HWY_DYNAMIC_DISPATCH(sum_over_springs)(springs, grid, x, v);
}

ParticleSums sum_over_particles(const Grid& grid, const Points& x, const Points& v) {
    return HWY_DYNAMIC_DISPATCH(sum_over_particles)(grid, x, v);
}

}  // namespace drape::kernels
#endif
