#include "closest_points.h"

#include <limits>

#include "drape/contact/closest_point.h"

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE Lanes3<hn::Vec<D>> load3(D d, const CellBatch::Vectors& from, std::size_t k) {
    return {hn::Load(d, from[0].data() + k), hn::Load(d, from[1].data() + k), hn::Load(d, from[2].data() + k)};
}

/// a + w b
template <class V>
HWY_INLINE Lanes3<V> moved_along(const Lanes3<V>& a, V w, const Lanes3<V>& b) {
    return {hn::Add(a.x, hn::Mul(w, b.x)), hn::Add(a.y, hn::Mul(w, b.y)), hn::Add(a.z, hn::Mul(w, b.z))};
}

template <class M, class V>
HWY_INLINE Lanes3<V> chosen(M mask, const Lanes3<V>& yes, const Lanes3<V>& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

/// In the order of Eigen, which adds up a pair of doubles first.
template <class V>
HWY_INLINE V dot3(const Lanes3<V>& a, const Lanes3<V>& b) {
    const V x = hn::Mul(a.x, b.x), y = hn::Mul(a.y, b.y), z = hn::Mul(a.z, b.z);
    return sizeof(Real) == sizeof(double) ? hn::Add(hn::Add(x, y), z) : hn::Add(x, hn::Add(y, z));
}

template <class V>
HWY_INLINE V difference_of_products(V a, V b, V c, V d) {
    return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

template <class V>
HWY_INLINE Lanes3<V> cross3(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// `is_needle` of closest_point.cpp.
template <class D, class L>
HWY_INLINE hn::Mask<D> needles(D d, const L& ab, const L& ac, const L& bc) {
    constexpr Real smallest = std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon();
    const auto longest = hn::Max(hn::Max(dot3(ab, ab), dot3(ac, ac)), dot3(bc, bc));
    const auto least = hn::Mul(hn::Mul(hn::Set(d, Real(1) / 64), longest), longest);
    const L across = cross3(ab, ac);
    return hn::Not(hn::Gt(dot3(across, across), hn::Max(least, hn::Set(d, smallest))));
}

/// The regions of the plane, each point in one, and the weights of b and c as quotients.
template <class D>
struct Regions {
    hn::Mask<D> at_a, at_b, at_c, on_bc, needle;
    hn::Vec<D> of_b, of_c, whole;
};

/// The quotients of corners have 1 below, and on side b-c the weight of b is left to that of c.
template <class D, class L>
HWY_INLINE Regions<D> regions_of(D d, const L& ab, const L& ac, const L& bc, const L& ap, const L& bp, const L& cp) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, Real(1));
    const V d1 = dot3(ab, ap), d2 = dot3(ac, ap), d3 = dot3(ab, bp), d4 = dot3(ac, bp), d5 = dot3(ab, cp),
            d6 = dot3(ac, cp);
    const auto at_a = hn::And(hn::Le(d1, zero), hn::Le(d2, zero));
    const auto at_b = hn::AndNot(at_a, hn::And(hn::Ge(d3, zero), hn::Le(d4, d3)));
    const auto at_c = hn::AndNot(hn::Or(at_a, at_b), hn::And(hn::Ge(d6, zero), hn::Le(d5, d6)));
    const auto corner = hn::Or(at_a, hn::Or(at_b, at_c));

    const V vc = difference_of_products(d1, d4, d3, d2), vb = difference_of_products(d5, d2, d1, d6),
            va = difference_of_products(d3, d6, d5, d4);
    const V along = hn::Sub(d4, d3), back = hn::Sub(d5, d6);
    const auto on_ab = hn::And(hn::Le(vc, zero), hn::And(hn::Ge(d1, zero), hn::Le(d3, zero)));
    const auto on_ac = hn::AndNot(on_ab, hn::And(hn::Le(vb, zero), hn::And(hn::Ge(d2, zero), hn::Le(d6, zero))));
    const auto on_bc = hn::AndNot(hn::Or(corner, hn::Or(on_ab, on_ac)),
                                  hn::And(hn::Le(va, zero), hn::And(hn::Ge(d4, d3), hn::Ge(d5, d6))));

    const auto pick = [&](V inside, V bc_side, V ac_side, V ab_side, V of_corner) HWY_ATTR {
        const V side = hn::IfThenElse(on_ac, ac_side, hn::IfThenElse(on_bc, bc_side, inside));
        return hn::IfThenElse(corner, of_corner, hn::IfThenElse(on_ab, ab_side, side));
    };
    return {at_a,
            at_b,
            at_c,
            on_bc,
            hn::AndNot(corner, needles(d, ab, ac, bc)),
            pick(vb, zero, zero, d1, hn::IfThenElseZero(at_b, one)),
            pick(vc, along, d2, zero, hn::IfThenElseZero(at_c, one)),
            pick(hn::Add(hn::Add(va, vb), vc), hn::Add(along, back), hn::Sub(d2, d6), hn::Sub(d1, d3), one)};
}

template <class D>
HWY_INLINE void store3(D d, const Lanes3<hn::Vec<D>>& from, CellBatch::Vectors& to, std::size_t k) {
    hn::Store(from.x, d, to[0].data() + k);
    hn::Store(from.y, d, to[1].data() + k);
    hn::Store(from.z, d, to[2].data() + k);
}

/// One triangle of each cell from k on.
/// @return which of them are needles, a bit each: what is stored of these does not count
template <class D>
HWY_INLINE std::uint32_t closest_of(D d, CellBatch& batch, const Lanes3<hn::Vec<D>>& p, std::size_t second,
                                    std::size_t k) {
    using V = hn::Vec<D>;
    const auto& corners = CellBatch::corners_of[second];
    const Lanes3<V> a = load3(d, batch.corners[corners[0]], k), b = load3(d, batch.corners[corners[1]], k),
                    c = load3(d, batch.corners[corners[2]], k);
    const Lanes3<V> ab = minus(b, a), ac = minus(c, a), bc = minus(c, b);
    const Regions<D> in = regions_of(d, ab, ac, bc, minus(p, a), minus(p, b), minus(p, c));

    const V one = hn::Set(d, Real(1)), quotient = hn::Div(in.of_b, in.whole), w = hn::Div(in.of_c, in.whole);
    const V v = hn::IfThenElse(in.on_bc, hn::Sub(one, w), quotient);
    const V u = hn::IfThenZeroElse(in.on_bc, hn::Sub(hn::Sub(one, v), w));
    const Lanes3<V> inside = moved_along(moved_along(a, v, ab), w, ac);
    const Lanes3<V> other = chosen(in.at_b, b, chosen(in.at_c, c, chosen(in.on_bc, moved_along(b, w, bc), inside)));
    const Lanes3<V> point = chosen(in.at_a, a, other), off = minus(point, p);
    CellBatch::Closest& closest = batch.closest[second];
    store3(d, {u, v, w}, closest.barycentric, k);
    store3(d, point, closest.point, k);
    hn::Store(dot3(off, off), d, closest.square.data() + k);
    return lane_bits(d, in.needle);
}

std::uint32_t closest_points_of(CellBatch& batch, std::size_t second, const Vec3& centre) {
    const hn::CappedTag<Real, 16> d;
    const Lanes3<hn::Vec<decltype(d)>> p{hn::Set(d, centre[0]), hn::Set(d, centre[1]), hn::Set(d, centre[2])};
    std::uint32_t needles = 0;
    for (std::size_t k = 0; k < batch.count; k += hn::Lanes(d)) needles |= closest_of(d, batch, p, second, k) << k;
    return needles;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <bit>

namespace drape::kernels {

HWY_EXPORT(closest_points_of);

namespace {

void find_of_needle(CellBatch& batch, std::size_t second, std::size_t k, const Vec3& centre) {
    const auto corner = [&](std::size_t of_triangle) {
        const CellBatch::Vectors& at = batch.corners[CellBatch::corners_of[second][of_triangle]];
        return Vec3(at[0][k], at[1][k], at[2][k]);
    };
    const ClosestPoint found = closest_point_on_triangle(centre, corner(0), corner(1), corner(2));
    CellBatch::Closest& closest = batch.closest[second];
    for (std::size_t i = 0; i < 3; ++i) {
        closest.barycentric[i][k] = found.barycentric[i];
        closest.point[i][k] = found.point[static_cast<Eigen::Index>(i)];
    }
    closest.square[k] = (found.point - centre).squaredNorm();
}

}  // namespace

void find_closest_points(CellBatch& batch, const Vec3& centre) {
    const std::uint64_t used = (std::uint64_t{1} << batch.count) - 1;
    for (const std::size_t second : {0u, 1u}) {
        std::uint64_t needles = used & HWY_DYNAMIC_DISPATCH(closest_points_of)(batch, second, centre);
        for (; needles != 0; needles &= needles - 1) {
            find_of_needle(batch, second, static_cast<std::size_t>(std::countr_zero(needles)), centre);
        }
    }
}

}  // namespace drape::kernels
#endif
