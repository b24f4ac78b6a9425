#include "batch_sweeps.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/kernels/batch_sweeps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE hn::Vec<D> of(D d, const ContactBatch::Numbers& numbers, std::size_t lane) {
    return hn::Load(d, numbers.data() + lane);
}

template <class D>
HWY_INLINE Lanes3<hn::Vec<D>> of(D d, const ContactBatch::Vectors& vectors, std::size_t lane) {
    return {of(d, vectors[0], lane), of(d, vectors[1], lane), of(d, vectors[2], lane)};
}

/// Where the motion of particles is, and how it is read and written there.
template <class D>
class Slots {
public:
    HWY_INLINE Slots(D d, const ContactBatch& batch, std::size_t k, std::size_t lane, Real* motion)
        : d_(d),
          in_a_row_(batch.in_a_row[k]),
          from_(in_a_row_ ? motion + batch.particles[k].slots[0] + lane : motion),
          slots_(hn::Load(hn::RebindToSigned<D>(), batch.particles[k].slots.data() + lane)) {}

    HWY_INLINE Lanes3<hn::Vec<D>> read() const {
        return {read_axis(from_), read_axis(from_ + ContactBatch::size), read_axis(from_ + 2 * ContactBatch::size)};
    }
    HWY_INLINE void write(const Lanes3<hn::Vec<D>>& now) const {
        write_axis(now.x, from_);
        write_axis(now.y, from_ + ContactBatch::size);
        write_axis(now.z, from_ + 2 * ContactBatch::size);
    }

private:
    HWY_INLINE hn::Vec<D> read_axis(const Real* from) const {
        return in_a_row_ ? hn::Load(d_, from) : hn::GatherIndex(d_, from, slots_);
    }
    HWY_INLINE void write_axis(hn::Vec<D> now, Real* to) const {
        if (in_a_row_) {
            hn::Store(now, d_, to);
        } else {
            hn::ScatterIndex(now, d_, to, slots_);
        }
    }

    D d_;
    bool in_a_row_;
    Real* from_;
    hn::Vec<hn::RebindToSigned<D>> slots_;
};

/// std::max(a, b)
template <class V>
HWY_INLINE V larger(V a, V b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
}

/// `friction_within`
template <class D, class L>
HWY_INLINE L friction_up_to(D d, hn::Vec<D> most, const L& wanted) {
    const auto square = eigen_dot(wanted, wanted);
    const auto slides = hn::Gt(square, hn::Mul(most, most));
    if (hn::AllFalse(d, slides)) return wanted;
    const L bounded = times(wanted, hn::Div(most, hn::Sqrt(square)));
    return {hn::IfThenElse(slides, bounded.x, wanted.x), hn::IfThenElse(slides, bounded.y, wanted.y),
            hn::IfThenElse(slides, bounded.z, wanted.z)};
}

/// `solve_contact`
template <std::size_t particles, class D>
HWY_INLINE hn::Vec<D> solve(D d, ContactBatch& batch, std::size_t lane, Real* motion) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d);
    Lanes3<V> moves{zero, zero, zero};
    for (std::size_t k = 0; k < particles; ++k) {
        const V weight = of(d, batch.particles[k].weight, lane);
        moves = plus(moves, times(Slots<D>(d, batch, k, lane, motion).read(), weight));
    }
    moves = minus(minus(moves, of(d, batch.start, lane)), of(d, batch.body, lane));

    const Lanes3<V> normal = of(d, batch.normal, lane), friction_before = of(d, batch.friction, lane);
    const V along = eigen_dot(moves, normal), mass = of(d, batch.mass, lane), push_before = of(d, batch.push, lane);
    const V grown = hn::Add(push_before, hn::Mul(hn::Sub(of(d, batch.target, lane), along), mass));
    const V push = larger(grown, zero);
    const Lanes3<V> sliding = minus(moves, times(normal, along));
    const Lanes3<V> wanted = minus(friction_before, times(sliding, of(d, batch.sliding_mass, lane)));
    const Lanes3<V> friction = friction_up_to(d, hn::Mul(of(d, batch.friction_coefficient, lane), push), wanted);
    const Lanes3<V> change =
        plus(times(normal, hn::Sub(push, push_before)), minus(friction, friction_before));

    const auto none = hn::And(hn::Le(hn::Abs(change.x), zero),
                              hn::And(hn::Le(hn::Abs(change.y), zero), hn::Le(hn::Abs(change.z), zero)));
    const auto changes = hn::AndNot(none, hn::Gt(mass, zero));
    if (hn::AllFalse(d, changes)) return zero;
    const auto store = [&](V now, V before, ContactBatch::Numbers& to) HWY_ATTR {
        hn::Store(hn::IfThenElse(changes, now, before), d, to.data() + lane);
    };
    store(push, push_before, batch.push);
    store(friction.x, friction_before.x, batch.friction[0]);
    store(friction.y, friction_before.y, batch.friction[1]);
    store(friction.z, friction_before.z, batch.friction[2]);
    for (std::size_t k = 0; k < particles; ++k) {
        const Slots<D> slots(d, batch, k, lane, motion);
        const Lanes3<V> before = slots.read(), now = plus(before, times(change, of(d, batch.particles[k].share, lane)));
        slots.write({hn::IfThenElse(changes, now.x, before.x), hn::IfThenElse(changes, now.y, before.y),
                     hn::IfThenElse(changes, now.z, before.z)});
    }
    const V inverse_mass = of(d, batch.inverse_mass, lane);
    return hn::IfThenElseZero(changes, hn::Mul(hn::Mul(eigen_dot(change, change), inverse_mass), inverse_mass));
}

template <std::size_t particles, class D>
HWY_INLINE hn::Vec<D> solve_all(D d, ContactBatch& batch, Real* motion, hn::Vec<D> square) {
    for (std::size_t lane = 0; lane < batch.contact_count; lane += hn::Lanes(d)) {
        square = larger(square, solve<particles>(d, batch, lane, motion));
    }
    return square;
}

Real sweep_batches_of(std::span<ContactBatch> batches, Real* motion) {
    const hn::CappedTag<Real, ContactBatch::size> d;
    hn::Vec<decltype(d)> square = hn::Zero(d);
    for (ContactBatch& batch : batches) {
        switch (batch.particle_count) {
            case 1:
                square = solve_all<1>(d, batch, motion, square);
                break;
            case 2:
                square = solve_all<2>(d, batch, motion, square);
                break;
            default:
                square = solve_all<3>(d, batch, motion, square);
                break;
        }
    }
    return hn::GetLane(hn::MaxOfLanes(d, square));
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sweep_batches_of);

Real sweep_batches(std::span<ContactBatch> batches, Real* motion) {
    return HWY_DYNAMIC_DISPATCH(sweep_batches_of)(batches, motion);
}

}  // namespace drape::kernels
#endif
