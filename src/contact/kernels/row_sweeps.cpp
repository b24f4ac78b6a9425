#include "row_sweeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/kernels/row_sweeps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// A vector in space, in registers.
struct Three {
    Real x, y, z;
};

HWY_INLINE Three of(const Vec3& v) { return {v[0], v[1], v[2]}; }
HWY_INLINE Three operator+(const Three& a, const Three& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE Three operator-(const Three& a, const Three& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Three operator*(Real factor, const Three& a) { return {factor * a.x, factor * a.y, factor * a.z}; }

/// In the order of Eigen, which adds up a pair of doubles first.
HWY_INLINE Real eigen_dot(const Three& a, const Three& b) {
    const Real x = a.x * b.x, y = a.y * b.y, z = a.z * b.z;
    return sizeof(Real) == sizeof(double) ? (x + y) + z : x + (y + z);
}

HWY_INLINE bool is_zero(const Three& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

/// The motion of the particles of a cloth.
struct Motion {
    Real *x, *y, *z;

    HWY_INLINE Three operator[](int p) const { return {x[p], y[p], z[p]}; }
    HWY_INLINE void add(int p, const Three& change) const {
        x[p] += change.x;
        y[p] += change.y;
        z[p] += change.z;
    }
};

/// `relative`
template <int particles, int offsets>
HWY_INLINE Three relative_motion(const Motion& motion, const CompactContact& row) {
    Three sum = Three{0, 0, 0} + row.weights[0] * motion[row.particles[0]];
    if constexpr (particles > 1) sum = sum + row.weights[1] * motion[row.particles[1]];
    if constexpr (particles > 2) sum = sum + row.weights[2] * motion[row.particles[2]];
    if constexpr (offsets > 0) sum = sum - of(row.offsets[0]);
    if constexpr (offsets > 1) sum = sum - of(row.offsets[1]);
    return sum;
}

/// `solve_contact`
template <int particles, int offsets>
HWY_INLINE Real solve_row(const Motion& motion, CompactContact& row) {
    const Three moves = relative_motion<particles, offsets>(motion, row), n = of(row.normal), before = of(row.friction);
    const Real along = eigen_dot(moves, n);
    const Real normal = std::max(row.push + (row.target - along) * row.mass, Real(0));
    const Real most = row.friction_coefficient * normal;
    const Three wanted = before - row.sliding_mass * (moves - along * n);
    const Real square = eigen_dot(wanted, wanted);
    // Most contacts that carry nothing go on so, and need no root
    const bool idle = normal == 0 && row.push == 0 && is_zero(before);
    if (idle && square < std::numeric_limits<Real>::infinity()) return 0;
    const Three friction = square > most * most ? (most / std::sqrt(square)) * wanted : wanted;
    const Three push = (normal - row.push) * n + (friction - before);
    if (is_zero(push)) return 0;
    row.push = normal;
    row.friction = Vec3(friction.x, friction.y, friction.z);
    motion.add(row.particles[0], row.shares[0] * push);
    if constexpr (particles > 1) motion.add(row.particles[1], row.shares[1] * push);
    if constexpr (particles > 2) motion.add(row.particles[2], row.shares[2] * push);
    return eigen_dot(push, push) * row.inverse_mass * row.inverse_mass;
}

template <int offsets>
HWY_INLINE Real sweep(const Motion& motion, std::span<CompactContact> rows) {
    Real square = 0;
    for (CompactContact& row : rows) {
        const Real changed = row.count == 3   ? solve_row<3, offsets>(motion, row)
                             : row.count == 2 ? solve_row<2, offsets>(motion, row)
                                              : solve_row<1, offsets>(motion, row);
        square = std::max(square, changed);
    }
    return square;
}

Real sweep_rows_of(const ClothRows& cloth, std::span<CompactContact> rows, int offsets) {
    const Motion motion{cloth.motion, cloth.motion + cloth.stride, cloth.motion + 2 * cloth.stride};
    switch (offsets) {
        case 0:
            return sweep<0>(motion, rows);
        case 1:
            return sweep<1>(motion, rows);
        default:
            return sweep<2>(motion, rows);
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sweep_rows_of);

Real sweep_rows(const ClothRows& cloth, std::span<CompactContact> rows, int offsets) {
    return HWY_DYNAMIC_DISPATCH(sweep_rows_of)(cloth, rows, offsets);
}

}  // namespace drape::kernels
#endif
