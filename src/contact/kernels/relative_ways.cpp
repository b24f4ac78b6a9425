#include "relative_ways.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/kernels/relative_ways.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls visit(d, p) for the first particle of each vector, and then for each that is left alone.
template <class Visit>
HWY_INLINE void for_all_particles(std::size_t particles, Visit visit) {
    const hn::CappedTag<Real, 16> d;
    std::size_t p = 0;
    for (; p + hn::Lanes(d) <= particles; p += hn::Lanes(d)) visit(d, p);
    for (; p < particles; ++p) visit(hn::CappedTag<Real, 1>(), p);
}

/// `length_of` of a vector of particles.
template <class D>
HWY_INLINE hn::Vec<D> lengths(D d, const Points& from, const Points& to, const Vec3& common, std::size_t p) {
    const auto along = [&](int axis) HWY_ATTR {
        return hn::Sub(hn::Sub(hn::LoadU(d, to.col(axis).data() + p), hn::LoadU(d, from.col(axis).data() + p)),
                       hn::Set(d, common[axis]));
    };
    const Lanes3<hn::Vec<D>> own{along(0), along(1), along(2)};
    return hn::Sqrt(dot(own, own));
}

/// Sixteen running sums, whatever the width of the vectors, which are then added up in turn.
WaySums sum_ways_of(const Points& before, const Points& now) {
    constexpr std::size_t sums = 16;
    const hn::CappedTag<Real, sums> d;
    constexpr std::size_t lanes = hn::MaxLanes(d), vectors = sums / lanes;
    const auto count = static_cast<std::size_t>(before.rows());
    WaySums all;
    for (int axis = 0; axis < 3; ++axis) {
        const Real *from = before.col(axis).data(), *to = now.col(axis).data();
        hn::Vec<decltype(d)> at[vectors], way[vectors];
        for (std::size_t v = 0; v < vectors; ++v) at[v] = way[v] = hn::Zero(d);
        std::size_t p = 0;
        for (; p + sums <= count; p += sums) {
            for (std::size_t v = 0; v < vectors; ++v) {
                const auto start = hn::LoadU(d, from + p + v * lanes);
                at[v] = hn::Add(at[v], start);
                way[v] = hn::Add(way[v], hn::Sub(hn::LoadU(d, to + p + v * lanes), start));
            }
        }
        HWY_ALIGN Real of_at[sums], of_way[sums];
        for (std::size_t v = 0; v < vectors; ++v) {
            hn::Store(at[v], d, of_at + v * lanes);
            hn::Store(way[v], d, of_way + v * lanes);
        }
        for (; p < count; ++p) {
            of_at[p % sums] += from[p];
            of_way[p % sums] += to[p] - from[p];
        }
        for (std::size_t s = 0; s < sums; ++s) {
            all.before[axis] += of_at[s];
            all.way[axis] += of_way[s];
        }
    }
    return all;
}

bool find_reaches_of(const RelativeWays& ways, Real least, Real factor, std::span<const Real> allowed,
                     std::span<Real> reaches, std::span<Real> strayed) {
    bool all_within = true;
    for_all_particles(reaches.size(), [&](auto d, std::size_t p) HWY_ATTR {
        const auto way = lengths(d, ways.before, ways.now, ways.common, p);
        const auto reach = hn::Add(hn::Set(d, least), hn::Mul(hn::Set(d, factor), way));
        const auto stray = hn::Add(reach, lengths(d, ways.kept, ways.before, ways.since_kept, p));
        hn::StoreU(reach, d, reaches.data() + p);
        hn::StoreU(stray, d, strayed.data() + p);
        all_within = all_within && hn::AllTrue(d, hn::Le(stray, hn::LoadU(d, allowed.data() + p)));
    });
    return all_within;
}

bool are_within_of(const RelativeWays& ways, Real margin, std::span<const Real> reaches) {
    bool all_within = true;
    for_all_particles(reaches.size(), [&](auto d, std::size_t p) HWY_ATTR {
        const auto way = lengths(d, ways.before, ways.now, ways.common, p);
        const auto within = hn::Le(hn::Add(way, hn::Set(d, margin)), hn::LoadU(d, reaches.data() + p));
        all_within = all_within && hn::AllTrue(d, within);
    });
    return all_within;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sum_ways_of);
HWY_EXPORT(find_reaches_of);
HWY_EXPORT(are_within_of);

WaySums sum_ways(const Points& before, const Points& now) { return HWY_DYNAMIC_DISPATCH(sum_ways_of)(before, now); }

bool find_reaches(const RelativeWays& ways, Real least, Real factor, std::span<const Real> allowed,
                  std::span<Real> reaches, std::span<Real> strayed) {
    return HWY_DYNAMIC_DISPATCH(find_reaches_of)(ways, least, factor, allowed, reaches, strayed);
}

bool are_within(const RelativeWays& ways, Real margin, std::span<const Real> reaches) {
    return HWY_DYNAMIC_DISPATCH(are_within_of)(ways, margin, reaches);
}

}  // namespace drape::kernels
#endif
