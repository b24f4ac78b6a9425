#include <limits>
#include <utility>

#include "drape/bounds/dop_axes.h"
#include "patch_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Some figures of each particle of a vector.
template <class V, std::size_t count>
struct Figures {
    V figure[count];
};

/// The smallest and the largest of each figure.
/// @param figures_at called as figures_at(d, p) for the vector of particles from p on
template <std::size_t... k, class FiguresAt>
HWY_INLINE void extents(const Patch& patch, Real* low, Real* high, std::index_sequence<k...>, FiguresAt figures_at) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        using V = hn::Vec<decltype(d)>;
        V least[sizeof...(k)], most[sizeof...(k)];
        ((least[k] = hn::Set(d, std::numeric_limits<Real>::infinity()), most[k] = hn::Neg(least[k])), ...);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const auto of = figures_at(d, j * patch.stride + i);
            ((least[k] = hn::Min(least[k], of.figure[k]), most[k] = hn::Max(most[k], of.figure[k])), ...);
        });
        ((low[k] = smallest_lane(d, least[k]), high[k] = largest_lane(d, most[k])), ...);
    });
}

/// The terms of a sum so far, and one more: added, taken off or left out. In the order of `dop_projection`.
template <int factor, class V>
HWY_INLINE V plus(V sum, V term) {
    if constexpr (factor > 0)
        return hn::Add(sum, term);
    else if constexpr (factor < 0)
        return hn::Sub(sum, term);
    else
        return sum;
}

template <int number, class V>
HWY_INLINE V projection(V x, V y, V z) {
    constexpr auto axis = dop_axes[number];
    if constexpr (axis[0] != 0)
        return plus<axis[2]>(plus<axis[1]>(x, y), z);
    else if constexpr (axis[1] != 0)
        return plus<axis[2]>(y, z);
    else
        return z;
}

template <int K, std::size_t... k>
HWY_INLINE void dop_extents_in(const Patch& patch, Real* low, Real* high, std::index_sequence<k...> each) {
    extents(patch, low, high, each, [&](auto d, int p) HWY_ATTR {
        using V = hn::Vec<decltype(d)>;
        const V x = loaded_once(hn::LoadU(d, patch.x + p)), y = loaded_once(hn::LoadU(d, patch.y + p)),
                z = loaded_once(hn::LoadU(d, patch.z + p));
        return Figures<V, K / 2>{{projection<dop_numbers<K>[k]>(x, y, z)...}};
    });
}

void dop_extents_of(const Patch& patch, int slabs, Real* low, Real* high) {
    if (slabs == 3)
        dop_extents_in<6>(patch, low, high, std::make_index_sequence<3>());
    else if (slabs == 7)
        dop_extents_in<14>(patch, low, high, std::make_index_sequence<7>());
    else if (slabs == 9)
        dop_extents_in<18>(patch, low, high, std::make_index_sequence<9>());
    else
        dop_extents_in<26>(patch, low, high, std::make_index_sequence<13>());
}

void extents_along_of(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high) {
    extents(patch, low, high, std::make_index_sequence<3>(), [&](auto d, int p) HWY_ATTR {
        const auto offset = minus(particles_from(d, patch, p), in_each_lane(d, origin));
        Figures<hn::Vec<decltype(d)>, 3> along;
        for (int k = 0; k < 3; ++k) along.figure[k] = dot(offset, in_each_lane(d, axes.data() + 3 * k));
        return along;
    });
}

/// The largest value so far of each lane, and where its vector started.
template <class D>
class Highest {
public:
    explicit Highest(D d) : value_(hn::Set(d, hwy::LowestValue<Real>())), start_(hn::Zero(starts_)) {}

    HWY_INLINE void see(hn::Vec<D> value, ParticleIndex start) {
        const auto higher = hn::Gt(value, value_);
        value_ = hn::IfThenElse(higher, value, value_);
        start_ = hn::IfThenElse(hn::RebindMask(starts_, higher), hn::Set(starts_, static_cast<Start>(start)), start_);
    }

    /// Each lane has seen its particles in ascending order, so that the first of equals does not depend on the lanes.
    HWY_INLINE ParticleIndex particle(D d) const {
        constexpr std::size_t lanes = hn::MaxLanes(D());
        HWY_ALIGN Real value[lanes];
        HWY_ALIGN Start start[lanes];
        hn::Store(value_, d, value);
        hn::Store(start_, starts_, start);
        ParticleIndex best = start[0];
        Real highest = value[0];
        for (std::size_t lane = 1; lane < lanes; ++lane) {
            const ParticleIndex here = static_cast<ParticleIndex>(start[lane]) + static_cast<ParticleIndex>(lane);
            if (value[lane] > highest || (value[lane] == highest && here < best)) highest = value[lane], best = here;
        }
        return best;
    }

private:
    using Starts = hn::RebindToSigned<D>;
    using Start = hn::TFromD<Starts>;
    Starts starts_;
    hn::Vec<D> value_;
    hn::Vec<Starts> start_;
};

ParticleIndex farthest_particle_of(const Patch& patch, const Vec3& from) {
    ParticleIndex found = 0;
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        Highest highest(d);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const int start = j * patch.stride + i;
            highest.see(square_to(d, patch, start, from), start);
        });
        found = highest.particle(d);
    });
    return found;
}

Extremes extreme_particles_of(const Patch& patch, const std::array<int, 3>& direction) {
    Extremes found{};
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        const auto along_line = in_each_lane(d, direction);
        Highest high(d), low(d);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const int start = j * patch.stride + i;
            const auto along = dot(along_line, particles_from(d, patch, start));
            high.see(along, start);
            low.see(hn::Neg(along), start);
        });
        found = {low.particle(d), high.particle(d)};
    });
    return found;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(dop_extents_of);
HWY_EXPORT(extents_along_of);
HWY_EXPORT(farthest_particle_of);
HWY_EXPORT(extreme_particles_of);

void dop_extents(const Patch& patch, int slabs, Real* low, Real* high) {
    HWY_DYNAMIC_DISPATCH(dop_extents_of)(patch, slabs, low, high);
}

void extents_along(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high) {
    HWY_DYNAMIC_DISPATCH(extents_along_of)(patch, origin, axes, low, high);
}

ParticleIndex farthest_particle(const Patch& patch, const Vec3& from) {
    return HWY_DYNAMIC_DISPATCH(farthest_particle_of)(patch, from);
}

Extremes extreme_particles(const Patch& patch, const std::array<int, 3>& direction) {
    return HWY_DYNAMIC_DISPATCH(extreme_particles_of)(patch, direction);
}

}  // namespace drape::kernels
#endif
