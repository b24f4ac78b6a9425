#pragma once

#include <span>

#include "drape/base/kernels.h"
#include "drape/base/real.h"
#include "drape/model/tiles.h"

namespace drape {

/// Of the particles of a tile, in an order that is always the same.
struct TileSums {
    Vec3 before = Vec3::Zero();  ///< of their positions at the start [m]
    Vec3 moved = Vec3::Zero();   ///< of what each has moved by since [m]
};

/// Adds up positions and displacements.
/// @param before, now n x 3 [m]
/// @param sums receives those of each tile
/// @par Cost O(particles)
void sum_tiles(const Tiles& tiles, const Points& before, const Points& now, std::span<TileSums> sums, Kernels kernels);

/// What the particles of a tile move by together, and what that can bring nearer.
struct TileMotion {
    Vec3 mean = Vec3::Zero();  ///< displacement; the bounds hold for any other one too, if not so tightly [m]
    Real local = 0;            ///< at least half of what a touching tile's differs from it by [m]
    Real overall = 0;          ///< at least what that of all cloth differs from it by, and no less than `local` [m]
};

/// Sets `local` and `overall` from the means.
/// @param of_all the same for all cloth [m]
/// @par Cost O(tiles)
void compare_tiles(const Tiles& tiles, const Vec3& of_all, std::span<TileMotion> motion);

/// How particles may come nearer to each other. What a tile moves by as a whole brings none of its particles nearer to
/// each other, and what two tiles move by together brings nothing of one nearer to anything of the other: particle p of
/// tile P comes nearer to particle q of tile Q by at most |d_p - m_P| + |m_P - m_Q| + |d_q - m_Q|, with the
/// displacements d and any m.
struct ParticleMotion {
    const Tiles& tiles;
    const Points &kept, &before, &now;       ///< some time ago, at the start of the substep and now, n x 3 [m]
    std::span<const TileMotion> since_kept;  ///< of each tile, from `kept` to `before`
    std::span<const TileMotion> within;      ///< the same from `before` to `now`
};

/// A number of each particle [m], towards particles of its own and of touching tiles, and towards all others.
template <class Number>
struct ReachSpans {
    std::span<Number> local, overall;  ///< overall is never less
};

/// For each particle, a least reach and what it has moved by times a factor; and with it, what the particle has strayed
/// by since some time ago.
/// @param reaches, strayed receive these
/// @param allowed that each may stray
/// @return whether none strays farther than it is allowed to
/// @par Cost O(particles)
bool find_reaches(const ParticleMotion& motion, Real least, Real factor, ReachSpans<const Real> allowed,
                  ReachSpans<Real> reaches, ReachSpans<Real> strayed, Kernels kernels);

/// Whether what each particle has moved by from `before` to `now`, and a margin [m], is within its local reach. Then it
/// is within the overall one too, if `find_reaches` has found both with a factor of at least 1.
/// @par Cost O(particles)
[[nodiscard]] bool are_within(const ParticleMotion& motion, Real margin, std::span<const Real> local_reaches,
                              Kernels kernels);

}  // namespace drape
