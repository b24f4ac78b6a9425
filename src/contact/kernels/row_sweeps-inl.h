
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/solve/problem.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<Real, 4>;

constexpr int part_lanes = static_cast<int>(hn::MaxLanes(D())), vectors = 4 / part_lanes;

/// A vector in space and a zero, in as many registers as they take.
struct Four {
    hn::Vec<D> part[vectors];
};

HWY_INLINE Four load(const Real4& from) {
    Four values;
    for (int p = 0; p < vectors; ++p) values.part[p] = hn::LoadU(D(), from.data() + p * part_lanes);
    return values;
}

HWY_INLINE void store(const Four& values, Real4& to) {
    for (int p = 0; p < vectors; ++p) hn::StoreU(values.part[p], D(), to.data() + p * part_lanes);
}

HWY_INLINE Four operator+(Four a, const Four& b) {
    for (int p = 0; p < vectors; ++p) a.part[p] = hn::Add(a.part[p], b.part[p]);
    return a;
}

HWY_INLINE Four operator-(Four a, const Four& b) {
    for (int p = 0; p < vectors; ++p) a.part[p] = hn::Sub(a.part[p], b.part[p]);
    return a;
}

HWY_INLINE Four operator*(Real factor, Four a) {
    for (int p = 0; p < vectors; ++p) a.part[p] = hn::Mul(hn::Set(D(), factor), a.part[p]);
    return a;
}

/// x, y or z.
template <int axis>
HWY_INLINE Real coordinate(const Four& a) {
    const auto part = a.part[axis / part_lanes];
    if constexpr (axis % part_lanes == 0) return hn::GetLane(part);
#if HWY_TARGET != HWY_SCALAR
    if constexpr (axis % part_lanes == 1) return hn::GetLane(hn::DupOdd(part));
    if constexpr (axis % part_lanes == 2) return hn::GetLane(hn::UpperHalf(hn::Half<D>(), part));
#endif
}

/// In the order of Eigen, which adds up a pair of doubles first.
HWY_INLINE Real eigen_dot(const Four& a, const Four& b) {
    Four product;
    for (int p = 0; p < vectors; ++p) product.part[p] = hn::Mul(a.part[p], b.part[p]);
    const Real x = coordinate<0>(product), y = coordinate<1>(product), z = coordinate<2>(product);
    return sizeof(Real) == sizeof(double) ? (x + y) + z : x + (y + z);
}

HWY_INLINE bool is_zero(const Four& a) {
    bool zero = true;
    for (int p = 0; p < vectors; ++p) zero = zero && hn::AllTrue(D(), hn::Eq(a.part[p], hn::Zero(D())));
    return zero;
}

HWY_INLINE void push_particle(Real mobility, const Four& push, Real4& motion) {
    store(load(motion) + mobility * push, motion);
}

/// `solve` of one contact. Each waits for the one before that pushes the same particle: branches that are mostly
/// foreseen are faster than what would be computed in their place.
template <int particles>
HWY_INLINE Real solve_row(std::span<Real4> motion, CompactRow& row) {
    const auto at = [&](std::size_t k) -> Real4& { return motion[static_cast<std::size_t>(row.places[k])]; };
    Four moves = load(Real4{}) + row.weights[0] * load(at(0));
    if constexpr (particles > 1) moves = moves + row.weights[1] * load(at(1));
    if constexpr (particles > 2) moves = moves + row.weights[2] * load(at(2));
    if constexpr (particles > 3) moves = moves + row.weights[3] * load(at(3));
    moves = moves - load(row.offsets[0]) - load(row.offsets[1]);
    const Four n = load(row.normal), before = load(row.friction);
    const Real along = eigen_dot(moves, n);
    const Real normal = std::max(row.impulse + (row.target - along) * row.mass, Real(0));
    const Real most = row.friction_coefficient * normal;
    const Four wanted = before - row.sliding_mass * (moves - along * n);
    const Real square = eigen_dot(wanted, wanted);
    // Most contacts that carry nothing go on so, and need no root
    const bool idle = normal == 0 && row.impulse == 0 && is_zero(before);
    if (idle && square < std::numeric_limits<Real>::infinity()) return 0;
    Four friction = wanted;
    if (square > most * most) friction = (most / std::sqrt(square)) * wanted;
    const Four push = (normal - row.impulse) * n + (friction - before);
    if (is_zero(push)) return 0;
    row.impulse = normal;
    store(friction, row.friction);
    push_particle(row.mobilities[0], push, at(0));
    if constexpr (particles > 1) push_particle(row.mobilities[1], push, at(1));
    if constexpr (particles > 2) push_particle(row.mobilities[2], push, at(2));
    if constexpr (particles > 3) push_particle(row.mobilities[3], push, at(3));
    return eigen_dot(push, push) * row.inverse_mass * row.inverse_mass;
}

Real sweep_rows_of(std::span<Real4> motion, std::span<CompactRow> rows) {
    Real square = 0;
    for (CompactRow& row : rows) {
        const Real changed = row.count == 4   ? solve_row<4>(motion, row)
                             : row.count == 3 ? solve_row<3>(motion, row)
                                              : solve_row<1>(motion, row);
        square = std::max(square, changed);
    }
    return square;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sweep_rows_of);

Real sweep_rows(std::span<Real4> motion, std::span<CompactRow> rows) {
    return HWY_DYNAMIC_DISPATCH(sweep_rows_of)(motion, rows);
}

}  // namespace drape::kernels
#endif
