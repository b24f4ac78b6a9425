// How far particles can come nearer to each other, counted against the motion of their tiles; plain and by vectors.

#include "drape/contact/tile_motion.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace drape {
namespace {

constexpr Kernels both[] = {Kernels::Plain, Kernels::Vector};
const Grid grids[] = {{2, 2}, {8, 8}, {9, 17}, {30, 21}};

/// Positions at three times, between which a cloth turns, stretches, and shakes a little.
struct ThreeTimes {
    explicit ThreeTimes(const Grid& grid, unsigned seed = 3)
        : tiles(grid), since_kept(tile_count()), within(tile_count()) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> unit(-1, 1);
        const auto noise = [&] {
            return Points(Points::NullaryExpr(grid.particles(), 3, [&] { return unit(random); }));
        };
        kept = noise();
        for (Points* to : {&before, &now}) {
            const Points& from = to == &before ? kept : before;
            const Eigen::Matrix<Real, 3, 3> turn = Eigen::Matrix<Real, 3, 3>::NullaryExpr([&] { return unit(random); });
            *to = from + Real(0.2) * from * turn + Real(0.02) * noise();
            to->rowwise() += Eigen::Matrix<Real, 1, 3>(Real(0.1), Real(0.2), Real(-0.3));
        }
        for (const auto& [motion, from, to] : {std::tuple(&since_kept, &kept, &before), {&within, &before, &now}}) {
            std::vector<TileSums> sums(tile_count());
            sum_tiles(tiles, *from, *to, sums, Kernels::Plain);
            Vec3 all = Vec3::Zero();
            for (std::size_t t = 0; t < sums.size(); ++t) {
                (*motion)[t].mean = sums[t].moved / static_cast<Real>(tiles.particles(static_cast<int>(t)).particles());
                all += sums[t].moved;
            }
            compare_tiles(tiles, all / static_cast<Real>(grid.particles()), *motion);
        }
    }

    [[nodiscard]] std::size_t tile_count() const { return static_cast<std::size_t>(tiles.count()); }
    [[nodiscard]] ParticleMotion motion() const { return {tiles, kept, before, now, since_kept, within}; }

    Tiles tiles;
    Points kept, before, now;
    std::vector<TileMotion> since_kept, within;
};

/// What is found for each particle.
struct Found {
    Found(const ThreeTimes& times, Real least, Real factor, Real allowed, Kernels kernels) {
        const auto particles = static_cast<std::size_t>(times.kept.rows());
        for (std::vector<Real>* numbers : {&local, &overall, &local_strayed, &overall_strayed})
            numbers->resize(particles);
        const std::vector<Real> may(particles, allowed);
        within = find_reaches(times.motion(), least, factor, {may, may}, {local, overall},
                              {local_strayed, overall_strayed}, kernels);
    }

    std::vector<Real> local, overall, local_strayed, overall_strayed;
    bool within;
};

bool are_local(const Grid& grid, int p, int q) {
    const int i = p % grid.nx, j = p / grid.nx, other_i = q % grid.nx, other_j = q / grid.nx;
    return in_touching_tiles(
        {std::min(i, other_i), std::max(i, other_i) + 1, std::min(j, other_j), std::max(j, other_j) + 1});
}

TEST(Tiles, HaveEachParticleOnce) {
    for (const Grid& grid : grids) {
        const Tiles tiles(grid);
        std::vector<int> tile_of(static_cast<std::size_t>(grid.particles()), -1);
        for (int t = 0; t < tiles.count(); ++t) {
            const GridRange range = tiles.particles(t);
            for (int j = range.first_row; j < range.end_row; ++j) {
                for (int i = range.first_column; i < range.end_column; ++i) {
                    EXPECT_EQ(std::exchange(tile_of[static_cast<std::size_t>(grid.particle(i, j))], t), -1);
                }
            }
        }
        for (int p = 0; p < grid.particles(); ++p) {
            const int t = tile_of[static_cast<std::size_t>(p)];
            ASSERT_GE(t, 0);
            for (int q = 0; q < grid.particles(); ++q) {
                const int u = tile_of[static_cast<std::size_t>(q)];
                const bool touch = std::abs(t % tiles.columns - u % tiles.columns) <= 1 &&
                                   std::abs(t / tiles.columns - u / tiles.columns) <= 1;
                ASSERT_EQ(are_local(grid, p, q), touch) << p << " and " << q;
            }
        }
    }
}

TEST(TileMotion, SumsUpWhatEachTileMovesBy) {
    for (const Grid& grid : grids) {
        const ThreeTimes times(grid);
        std::vector<TileSums> plain(times.tile_count()), vector(times.tile_count());
        sum_tiles(times.tiles, times.before, times.now, plain, Kernels::Plain);
        sum_tiles(times.tiles, times.before, times.now, vector, Kernels::Vector);
        TileSums all;
        for (std::size_t t = 0; t < plain.size(); ++t) {
            EXPECT_EQ(plain[t].before, vector[t].before);
            EXPECT_EQ(plain[t].moved, vector[t].moved);
            all.before += plain[t].before;
            all.moved += plain[t].moved;
        }
        const Real tolerance = 100 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(grid.particles());
        EXPECT_LT((all.before - times.before.colwise().sum().transpose()).norm(), tolerance);
        EXPECT_LT((all.moved - (times.now - times.before).colwise().sum().transpose()).norm(), tolerance);
    }
}

TEST(TileMotion, BringsNothingNearerThanBothReach) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        const Grid grid = grids[seed % 4];
        const ThreeTimes times(grid, seed);
        const Found found(times, 0, 1, 100, both[seed / 3]);
        const Real rounding = 100 * std::numeric_limits<Real>::epsilon();
        for (int p = 0; p < grid.particles(); ++p) {
            for (int q = p + 1; q < grid.particles(); ++q) {
                const auto k = static_cast<std::size_t>(p), m = static_cast<std::size_t>(q);
                const auto apart = [&](const Points& x) { return Vec3((x.row(p) - x.row(q)).transpose()); };
                const Real moved = (apart(times.now) - apart(times.before)).norm() - rounding;
                const Real strayed = moved + (apart(times.before) - apart(times.kept)).norm() - rounding;
                ASSERT_LE(moved, found.overall[k] + found.overall[m]) << p << " and " << q;
                ASSERT_LE(strayed, found.overall_strayed[k] + found.overall_strayed[m]) << p << " and " << q;
                if (!are_local(grid, p, q)) continue;
                ASSERT_LE(moved, found.local[k] + found.local[m]) << p << " and " << q;
                ASSERT_LE(strayed, found.local_strayed[k] + found.local_strayed[m]) << p << " and " << q;
            }
        }
    }
}

/// The means of tiles are compared at each side and at each corner.
TEST(TileMotion, DiffersFromEachTouchingTile) {
    const Tiles tiles({24, 24});
    for (int t = 0; t < 9; ++t) {
        std::vector<TileMotion> motion(9);
        motion[static_cast<std::size_t>(t)].mean = {2, 0, 0};
        compare_tiles(tiles, {1, 0, 0}, motion);
        for (int u = 0; u < 9; ++u) {
            const bool touch = std::abs(t % 3 - u % 3) <= 1 && std::abs(t / 3 - u / 3) <= 1;
            EXPECT_EQ(motion[static_cast<std::size_t>(u)].local, touch ? 1 : 0) << t << " and " << u;
            EXPECT_EQ(motion[static_cast<std::size_t>(u)].overall, 1);
        }
    }
}

/// A sheet in free fall that turns slowly has hardly any reach, and next to none within its tiles.
TEST(TileMotion, DoesNotCountWhatATileMovesByAsAWhole) {
    const Grid grid{40, 40};
    ThreeTimes times(grid);
    for (int p = 0; p < grid.particles(); ++p) {
        times.before.row(p) << Real(p % grid.nx) / 39, 0, Real(p / grid.nx) / 39;
        times.now.row(p) = times.before.row(p);
        times.now(p, 1) += times.before(p, 0) - 5;
    }
    for (std::size_t t = 0; t < times.tile_count(); ++t) {
        const GridRange range = times.tiles.particles(static_cast<int>(t));
        times.within[t].mean = {0, static_cast<Real>(range.first_column + range.end_column - 1) / 78 - 5, 0};
    }
    compare_tiles(times.tiles, {0, Real(-4.5), 0}, times.within);
    const Found found(times, 0, 1, 100, Kernels::Vector);
    EXPECT_NEAR(found.overall[0], 0.5, 1e-5);
    EXPECT_NEAR(found.local[0], (3.5 + 4) / 39, 1e-5);
}

TEST(TileMotion, HasReachesAndStraysOfTheFormula) {
    for (const Grid& grid : grids) {
        const ThreeTimes times(grid);
        const Found plain(times, Real(0.01), Real(1.5), 100, Kernels::Plain);
        const Found vector(times, Real(0.01), Real(1.5), 100, Kernels::Vector);
        EXPECT_TRUE(plain.within && vector.within);
        EXPECT_EQ(plain.local, vector.local);
        EXPECT_EQ(plain.overall, vector.overall);
        EXPECT_EQ(plain.local_strayed, vector.local_strayed);
        EXPECT_EQ(plain.overall_strayed, vector.overall_strayed);
        const TileMotion &within = times.within[0], &since = times.since_kept[0];
        const Real moved = (times.now.row(0).transpose() - times.before.row(0).transpose() - within.mean).norm();
        const Real moved_since = (times.before.row(0).transpose() - times.kept.row(0).transpose() - since.mean).norm();
        EXPECT_NEAR(plain.local[0], Real(0.01) + Real(1.5) * (moved + within.local), 1e-6);
        EXPECT_NEAR(plain.overall_strayed[0], plain.overall[0] + moved_since + since.overall, 1e-6);
    }
}

TEST(TileMotion, IsWithinWhatIsAllowedOnlyIfEachParticleIs) {
    const Grid grid{9, 17};
    const ThreeTimes times(grid);
    const Found found(times, Real(0.01), Real(1.5), 100, Kernels::Plain);
    const auto particles = static_cast<std::size_t>(grid.particles());
    std::vector<Real> local(particles), overall(particles), local_strayed(particles), overall_strayed(particles);
    for (const Kernels kernels : both) {
        std::vector<Real> may_local = found.local_strayed, may_overall = found.overall_strayed;
        const auto all_within = [&] {
            return find_reaches(times.motion(), Real(0.01), Real(1.5), {may_local, may_overall}, {local, overall},
                                {local_strayed, overall_strayed}, kernels);
        };
        EXPECT_TRUE(all_within());
        for (std::vector<Real>* may : {&may_local, &may_overall}) {
            for (Real& of_one : *may) {
                const Real enough = std::exchange(of_one, Real(0.999) * of_one);
                EXPECT_FALSE(all_within());
                of_one = enough;
            }
        }
    }
}

TEST(TileMotion, StaysWithinReachOnlyIfEachParticleDoes) {
    const ThreeTimes times({9, 17});
    std::vector<Real> reaches = Found(times, Real(0.011), 1, 100, Kernels::Plain).local;
    for (const Kernels kernels : both) {
        EXPECT_TRUE(are_within(times.motion(), Real(0.01), reaches, kernels));
        for (Real& reach : reaches) {
            const Real enough = std::exchange(reach, reach - Real(0.002));
            EXPECT_FALSE(are_within(times.motion(), Real(0.01), reaches, kernels));
            reach = enough;
        }
    }
}

}  // namespace
}  // namespace drape
