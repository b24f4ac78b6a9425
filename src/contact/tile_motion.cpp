#include "drape/contact/tile_motion.h"

#include <algorithm>
#include <cmath>

#include "contact_geometry.h"
#include "kernels/tile_motion.h"

namespace drape {
namespace {

/// Calls visit(tile, particle) for each particle, tile by tile.
template <class Visit>
void for_each_particle(const Tiles& tiles, Visit visit) {
    for (int tile = 0; tile < tiles.count(); ++tile) {
        const GridRange range = tiles.particles(tile);
        for (int j = range.first_row; j < range.end_row; ++j) {
            for (int i = range.first_column; i < range.end_column; ++i) visit(tile, tiles.grid.particle(i, j));
        }
    }
}

/// What a particle moves by, but for what its tile moves by.
Real own_motion(const Points& from, const Points& to, int p, const Vec3& mean) {
    const auto along = [&](int axis) { return to(p, axis) - from(p, axis) - mean[axis]; };
    return std::sqrt((along(0) * along(0) + along(1) * along(1)) + along(2) * along(2));
}

/// The sum of each column of a tile, and then of these.
Vec3 sum_columns(const Grid& grid, const GridRange& range, const auto& of_particle) {
    Vec3 columns[Tiles::side] = {};
    for (Vec3& column : columns) column.setZero();
    for (int j = range.first_row; j < range.end_row; ++j) {
        for (int i = range.first_column; i < range.end_column; ++i) {
            columns[i - range.first_column] += of_particle(grid.particle(i, j));
        }
    }
    Vec3 sum = Vec3::Zero();
    for (const Vec3& column : columns) sum += column;
    return sum;
}

}  // namespace

void sum_tiles(const Tiles& tiles, const Points& before, const Points& now, std::span<TileSums> sums, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::sum_tiles(tiles, before, now, sums);
    for (int tile = 0; tile < tiles.count(); ++tile) {
        const GridRange range = tiles.particles(tile);
        sums[static_cast<std::size_t>(tile)] = {
            sum_columns(tiles.grid, range, [&](int p) { return position(before, p); }),
            sum_columns(tiles.grid, range, [&](int p) { return Vec3(position(now, p) - position(before, p)); })};
    }
}

void compare_tiles(const Tiles& tiles, const Vec3& of_all, std::span<TileMotion> motion) {
    const auto at = [&](int row, int column) -> TileMotion& {
        return motion[static_cast<std::size_t>(row * tiles.columns + column)];
    };
    // Squares first: one root a tile
    for (TileMotion& tile : motion) tile.local = 0;
    for (int row = 0; row < tiles.rows; ++row) {
        for (int column = 0; column < tiles.columns; ++column) {
            const auto compare = [&](int other_row, int other_column) {
                if (other_row >= tiles.rows || other_column < 0 || other_column >= tiles.columns) return;
                TileMotion &tile = at(row, column), &other = at(other_row, other_column);
                const Real square = (tile.mean - other.mean).squaredNorm();
                tile.local = std::max(tile.local, square);
                other.local = std::max(other.local, square);
            };
            compare(row, column + 1), compare(row + 1, column - 1), compare(row + 1, column),
                compare(row + 1, column + 1);
        }
    }
    for (TileMotion& tile : motion) {
        tile.local = std::sqrt(tile.local) / 2;
        tile.overall = std::max(tile.local, (tile.mean - of_all).norm());
    }
}

bool find_reaches(const ParticleMotion& motion, Real least, Real factor, ReachSpans<const Real> allowed,
                  ReachSpans<Real> reaches, ReachSpans<Real> strayed, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::find_reaches(motion, least, factor, allowed, reaches, strayed);
    bool all_within = true;
    for_each_particle(motion.tiles, [&](int tile, int p) {
        const auto t = static_cast<std::size_t>(tile), k = static_cast<std::size_t>(p);
        const TileMotion &within = motion.within[t], &since = motion.since_kept[t];
        const Real moved = own_motion(motion.before, motion.now, p, within.mean);
        const Real moved_since = own_motion(motion.kept, motion.before, p, since.mean);
        reaches.local[k] = least + factor * (moved + within.local);
        reaches.overall[k] = least + factor * (moved + within.overall);
        strayed.local[k] = reaches.local[k] + (moved_since + since.local);
        strayed.overall[k] = reaches.overall[k] + (moved_since + since.overall);
        all_within = all_within && strayed.local[k] <= allowed.local[k] && strayed.overall[k] <= allowed.overall[k];
    });
    return all_within;
}

bool are_within(const ParticleMotion& motion, Real margin, std::span<const Real> local_reaches, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::are_within(motion, margin, local_reaches);
    bool all_within = true;
    for_each_particle(motion.tiles, [&](int tile, int p) {
        const TileMotion& within = motion.within[static_cast<std::size_t>(tile)];
        const Real moved = own_motion(motion.before, motion.now, p, within.mean) + within.local;
        all_within = all_within && moved + margin <= local_reaches[static_cast<std::size_t>(p)];
    });
    return all_within;
}

}  // namespace drape
