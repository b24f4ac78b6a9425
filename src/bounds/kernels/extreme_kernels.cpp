#include "extreme_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bounds/kernels/extreme_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

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
        const auto along_x = hn::Set(d, static_cast<Real>(direction[0]));
        const auto along_y = hn::Set(d, static_cast<Real>(direction[1]));
        const auto along_z = hn::Set(d, static_cast<Real>(direction[2]));
        Highest high(d), low(d);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const int start = j * patch.stride + i;
            const auto x = hn::Mul(along_x, hn::LoadU(d, patch.x + start));
            const auto y = hn::Mul(along_y, hn::LoadU(d, patch.y + start));
            const auto z = hn::Mul(along_z, hn::LoadU(d, patch.z + start));
            const auto along = hn::Add(hn::Add(x, y), z);
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

HWY_EXPORT(farthest_particle_of);
HWY_EXPORT(extreme_particles_of);

ParticleIndex farthest_particle(const Patch& patch, const Vec3& from) {
    return HWY_DYNAMIC_DISPATCH(farthest_particle_of)(patch, from);
}

Extremes extreme_particles(const Patch& patch, const std::array<int, 3>& direction) {
    return HWY_DYNAMIC_DISPATCH(extreme_particles_of)(patch, direction);
}

}  // namespace drape::kernels
#endif
