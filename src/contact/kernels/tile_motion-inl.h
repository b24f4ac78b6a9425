#include "tile_motion.h"

#include <algorithm>

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls visit(d, tile, p) for the vectors of particles of a grid, in the order of its rows: each is of one tile.
template <class Visit>
HWY_INLINE void for_vectors(const Tiles& tiles, Visit visit) {
    const hn::CappedTag<Real, Tiles::side> wide;
    const hn::CappedTag<Real, 2> narrow;
    const hn::CappedTag<Real, 1> one;
    const auto columns = static_cast<std::size_t>(tiles.grid.nx);
    const auto whole = columns / Tiles::side * Tiles::side;
    for (int j = 0; j < tiles.grid.ny; ++j) {
        const auto first = static_cast<std::size_t>(tiles.grid.particle(0, j));
        const auto first_tile = static_cast<std::size_t>(j / Tiles::side * tiles.columns);
        const auto tile_of = [&](std::size_t column) { return first_tile + column / Tiles::side; };
        std::size_t i = 0;
        for (; i < whole; i += hn::Lanes(wide)) visit(wide, tile_of(i), first + i);
        for (; i + hn::Lanes(narrow) <= columns; i += hn::Lanes(narrow)) visit(narrow, tile_of(i), first + i);
        for (; i < columns; ++i) visit(one, tile_of(i), first + i);
    }
}

/// `own_motion` of a vector of particles.
template <class D>
HWY_INLINE hn::Vec<D> own_motion(D d, const Points& from, const Points& to, const Vec3& mean, std::size_t p) {
    const auto along = [&](int axis) HWY_ATTR {
        return hn::Sub(hn::Sub(hn::LoadU(d, to.col(axis).data() + p), hn::LoadU(d, from.col(axis).data() + p)),
                       hn::Set(d, mean[axis]));
    };
    const Lanes3<hn::Vec<D>> own{along(0), along(1), along(2)};
    return hn::Sqrt(dot(own, own));
}

/// Along one axis, of some tiles of a row of them.
void sum_tiles_along(int axis, const Tiles& tiles, const Points& before, const Points& now, int first_tile,
                     int end_tile, std::span<TileSums> sums) {
    constexpr int most_tiles = 32;
    HWY_ALIGN Real at[most_tiles * Tiles::side], moved[most_tiles * Tiles::side];
    for (int tile = first_tile; tile < end_tile; tile += most_tiles) {
        const int end = std::min(tile + most_tiles, end_tile);
        const GridRange from = tiles.particles(tile), to = tiles.particles(end - 1);
        std::fill_n(at, most_tiles * Tiles::side, Real(0));
        std::fill_n(moved, most_tiles * Tiles::side, Real(0));
        const auto columns = static_cast<std::size_t>(to.end_column - from.first_column);
        for (int j = from.first_row; j < from.end_row; ++j) {
            const int first = tiles.grid.particle(from.first_column, j);
            const Real *start = before.col(axis).data() + first, *end_of = now.col(axis).data() + first;
            const auto add = [&](auto d, std::size_t i) HWY_ATTR {
                const auto x = hn::LoadU(d, start + i), change = hn::Sub(hn::LoadU(d, end_of + i), x);
                hn::StoreU(hn::Add(hn::LoadU(d, at + i), x), d, at + i);
                hn::StoreU(hn::Add(hn::LoadU(d, moved + i), change), d, moved + i);
            };
            const hn::CappedTag<Real, Tiles::side> d;
            std::size_t i = 0;
            for (; i + hn::Lanes(d) <= columns; i += hn::Lanes(d)) add(d, i);
            for (; i < columns; ++i) add(hn::CappedTag<Real, 1>(), i);
        }
        for (int t = tile; t < end; ++t) {
            TileSums& of = sums[static_cast<std::size_t>(t)];
            of.before[axis] = of.moved[axis] = 0;
            for (int column = 0; column < Tiles::side; ++column) {
                of.before[axis] += at[(t - tile) * Tiles::side + column];
                of.moved[axis] += moved[(t - tile) * Tiles::side + column];
            }
        }
    }
}

void sum_tiles_of(const Tiles& tiles, const Points& before, const Points& now, std::span<TileSums> sums) {
    for (int row = 0; row < tiles.rows; ++row) {
        for (int axis = 0; axis < 3; ++axis) {
            sum_tiles_along(axis, tiles, before, now, row * tiles.columns, (row + 1) * tiles.columns, sums);
        }
    }
}

bool find_reaches_of(const ParticleMotion& motion, Real least, Real factor, ReachSpans<const Real> allowed,
                     ReachSpans<Real> reaches, ReachSpans<Real> strayed) {
    bool all_within = true;
    for_vectors(motion.tiles, [&](auto d, std::size_t tile, std::size_t p) HWY_ATTR {
        const TileMotion &within = motion.within[tile], &since = motion.since_kept[tile];
        const auto moved = own_motion(d, motion.before, motion.now, within.mean, p);
        const auto moved_since = own_motion(d, motion.kept, motion.before, since.mean, p);
        const auto find = [&](Real add, Real add_since, const Real* may, Real* reaches_of, Real* strayed_of) HWY_ATTR {
            const auto reach = hn::Add(hn::Set(d, least), hn::Mul(hn::Set(d, factor), hn::Add(moved, hn::Set(d, add))));
            const auto stray = hn::Add(reach, hn::Add(moved_since, hn::Set(d, add_since)));
            hn::StoreU(reach, d, reaches_of + p);
            hn::StoreU(stray, d, strayed_of + p);
            return hn::AllTrue(d, hn::Le(stray, hn::LoadU(d, may + p)));
        };
        const bool local =
            find(within.local, since.local, allowed.local.data(), reaches.local.data(), strayed.local.data());
        const bool overall =
            find(within.overall, since.overall, allowed.overall.data(), reaches.overall.data(), strayed.overall.data());
        all_within = all_within && local && overall;
    });
    return all_within;
}

bool are_within_of(const ParticleMotion& motion, Real margin, std::span<const Real> local_reaches) {
    bool all_within = true;
    for_vectors(motion.tiles, [&](auto d, std::size_t tile, std::size_t p) HWY_ATTR {
        const TileMotion& within = motion.within[tile];
        const auto moved = hn::Add(own_motion(d, motion.before, motion.now, within.mean, p), hn::Set(d, within.local));
        const auto reach = hn::LoadU(d, local_reaches.data() + p);
        all_within = all_within && hn::AllTrue(d, hn::Le(hn::Add(moved, hn::Set(d, margin)), reach));
    });
    return all_within;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sum_tiles_of);
HWY_EXPORT(find_reaches_of);
HWY_EXPORT(are_within_of);

void sum_tiles(const Tiles& tiles, const Points& before, const Points& now, std::span<TileSums> sums) {
    HWY_DYNAMIC_DISPATCH(sum_tiles_of)(tiles, before, now, sums);
}

bool find_reaches(const ParticleMotion& motion, Real least, Real factor, ReachSpans<const Real> allowed,
                  ReachSpans<Real> reaches, ReachSpans<Real> strayed) {
    return HWY_DYNAMIC_DISPATCH(find_reaches_of)(motion, least, factor, allowed, reaches, strayed);
}

bool are_within(const ParticleMotion& motion, Real margin, std::span<const Real> local_reaches) {
    return HWY_DYNAMIC_DISPATCH(are_within_of)(motion, margin, local_reaches);
}

}  // namespace drape::kernels
#endif
