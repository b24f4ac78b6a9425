#include "flat_blocks.h"

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The same as `room_around`, for a vector of particles.
template <class D>
HWY_INLINE hn::Vec<D> room_around(D d, const BlockRoom& of, std::size_t middle) {
    using V = hn::Vec<D>;
    const auto nx = static_cast<std::ptrdiff_t>(of.grid.nx);
    const auto at = [&](std::ptrdiff_t row, std::ptrdiff_t column) HWY_ATTR {
        const auto p = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + row * nx + column);
        const auto load = [&](int axis) HWY_ATTR { return hn::LoadU(d, of.x.col(axis).data() + p); };
        return Lanes3<V>{load(0), load(1), load(2)};
    };
    const Real to_along = 1 / of.hx, to_across = 1 / of.hy;
    const Lanes3<V> along = times(minus(at(0, 1), at(0, -1)), hn::Set(d, to_along / 2));
    const Lanes3<V> across = times(minus(at(1, 0), at(-1, 0)), hn::Set(d, to_across / 2));
    const Lanes3<V> normal{hn::Sub(hn::Mul(along.y, across.z), hn::Mul(along.z, across.y)),
                           hn::Sub(hn::Mul(along.z, across.x), hn::Mul(along.x, across.z)),
                           hn::Sub(hn::Mul(along.x, across.y), hn::Mul(along.y, across.x))};
    const V normal_square = dot(normal, normal), of_square = hn::Div(hn::Set(d, Real(1)), normal_square);
    V of_along = hn::Zero(d), of_across = hn::Zero(d);
    const auto raise = [&](V& most, const Lanes3<V>& deviation) HWY_ATTR {
        const Lanes3<V> within = minus(deviation, times(normal, hn::Mul(dot(deviation, normal), of_square)));
        most = hn::Max(most, dot(within, within));
    };
    for (const std::ptrdiff_t k : {-1, 0, 1}) {
        for (const std::ptrdiff_t from : {-1, 0}) {
            raise(of_along, minus(times(minus(at(k, from + 1), at(k, from)), hn::Set(d, to_along)), along));
            raise(of_across, minus(times(minus(at(from + 1, k), at(from, k)), hn::Set(d, to_across)), across));
        }
    }
    V reach = hn::Zero(d);
    for (const std::ptrdiff_t row : {-1, 0, 1}) {
        for (const std::ptrdiff_t column : {-1, 0, 1}) {
            const auto p = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + row * nx + column);
            reach = hn::Max(reach, hn::LoadU(d, of.reaches.data() + p));
        }
    }
    const V a = dot(along, along), b = dot(across, across), ab = dot(along, across), two = hn::Set(d, Real(2));
    const V difference = hn::Sub(a, b);
    const V root = hn::Sqrt(hn::Add(hn::Mul(difference, difference), hn::Mul(hn::Mul(hn::Set(d, Real(4)), ab), ab)));
    const V larger = hn::Div(hn::Add(hn::Add(a, b), root), two), one = hn::Set(d, Real(1));
    const V rounding = hn::Mul(hn::Set(d, block_rounding), hn::Add(one, hn::Sqrt(larger)));
    const V smaller = hn::Sqrt(hn::Div(normal_square, larger));
    const V least = hn::Sub(hn::Sub(smaller, hn::Sqrt(hn::Add(of_along, of_across))), rounding);
    const V room = hn::Sub(hn::Mul(least, hn::Set(d, apart_at_rest(of.hx, of.hy))), hn::Mul(two, reach));
    return hn::IfThenElse(hn::Gt(normal_square, hn::Zero(d)), room, hn::Set(d, Real(-1)));
}

void find_block_room_of(const BlockRoom& of, std::span<Real> room) {
    const hn::CappedTag<Real, 8> d;
    const std::size_t columns = static_cast<std::size_t>(of.grid.nx - 2), lanes = hn::Lanes(d);
    for (int row = 0; row + 2 < of.grid.ny; ++row) {
        const auto first = static_cast<std::size_t>(of.grid.particle(1, row + 1));
        Real* const to = room.data() + static_cast<std::size_t>(row) * columns;
        std::size_t k = 0;
        for (; k + lanes <= columns; k += lanes) hn::StoreU(room_around(d, of, first + k), d, to + k);
        const hn::CappedTag<Real, 1> one;
        for (; k < columns; ++k) hn::StoreU(room_around(one, of, first + k), one, to + k);
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(find_block_room_of);

void find_block_room(const BlockRoom& of, std::span<Real> room) { HWY_DYNAMIC_DISPATCH(find_block_room_of)(of, room); }

}  // namespace drape::kernels
#endif
