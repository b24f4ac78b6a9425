// Blocks of 2 x 2 cells are called flat only where nothing in them can come near; plain and by vectors.

#include "drape/contact/flat_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "support/pairs_within_reach.h"

namespace drape {
namespace {

constexpr Real spacing = Real(0.1);
constexpr Kernels both_kinds[] = {Kernels::Plain, Kernels::Vector};

/// Rolled about an axis along z, compressed, sheared and ruffled.
Points crumpled(const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    const Real curvature = Real(0.5) + 6 * std::abs(unit(random)), noise = Real(0.03) * std::abs(unit(random));
    const Real shear = unit(random), narrow = 1 - Real(0.5) * std::abs(unit(random));
    Points x(grid.particles(), 3);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const Real z = spacing * static_cast<Real>(j);
            const Real angle = curvature * (spacing * static_cast<Real>(i) + shear * z);
            x.row(grid.particle(i, j)) << std::sin(angle) / curvature, std::cos(angle) / curvature, narrow * z;
        }
    }
    for (Real& value : x.reshaped()) value += noise * unit(random);
    return x;
}

using CellPairs = std::map<std::array<int, 2>, int>;

/// How many times each two cells are in blocks that are not flat.
CellPairs pairs_to_look_at(const FlatBlocks& blocks) {
    CellPairs pairs;
    for (const int block : blocks.uneven()) {
        blocks.for_each_pair_of_cells(block, [&](int one, int two) { ++pairs[{one, two}]; });
    }
    return pairs;
}

/// All touching cells, and each cell with itself, once.
CellPairs touching_cells(const Grid& grid) {
    const int columns = grid.cell_columns();
    CellPairs pairs;
    for (int one = 0; one < grid.cells(); ++one) {
        for (int two = one; two < grid.cells(); ++two) {
            const bool touch =
                std::abs(one % columns - two % columns) <= 1 && std::abs(one / columns - two / columns) <= 1;
            if (touch) pairs[{one, two}] = 1;
        }
    }
    return pairs;
}

TEST(FlatBlocks, HaveEachTwoTouchingCellsOnce) {
    for (const Grid& grid : {Grid{3, 3}, Grid{4, 7}, Grid{9, 5}, Grid{2, 2}, Grid{2, 6}, Grid{5, 2}}) {
        FlatBlocks blocks(grid, spacing, spacing);
        blocks.build(Points::Zero(grid.particles(), 3), std::vector<Real>(static_cast<std::size_t>(grid.particles())),
                     Kernels::Vector);
        EXPECT_EQ(pairs_to_look_at(blocks), touching_cells(grid)) << grid.nx << " x " << grid.ny;
    }
}

TEST(FlatBlocks, LeaveOutNothingThatIsWithinReach) {
    const Grid grid{12, 9};
    std::mt19937 random(5);
    std::uniform_real_distribution<Real> unit(0, 1);
    int flat = 0, nearly_touched = 0;
    std::size_t refused = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Points x = crumpled(grid, random);
        std::vector<Real> reaches(static_cast<std::size_t>(grid.particles()));
        const Real most = Real(0.04) * unit(random);
        for (Real& reach : reaches) reach = most * (1 - Real(0.2) * unit(random));
        std::vector<Real> farther = reaches;
        for (Real& reach : farther) reach *= Real(1.5);
        FlatBlocks blocks(grid, spacing, spacing);
        blocks.build(x, reaches, Kernels::Vector);
        const CellPairs looked_at = pairs_to_look_at(blocks);
        refused += looked_at.size();
        for (const auto& [cells, times] : touching_cells(grid)) {
            if (looked_at.contains(cells)) continue;
            ++flat;
            const int i = cells[0] % 11, j = cells[0] / 11, k = cells[1] % 11, m = cells[1] / 11;
            const CellRange first{i, j, i + 1, j + 1}, second{k, m, k + 1, m + 1};
            ASSERT_EQ(test::pairs_within_reach(grid, x, first, second, reaches), 0U) << "trial " << trial;
            nearly_touched += test::pairs_within_reach(grid, x, first, second, farther) > 0;
        }
    }
    EXPECT_GT(flat, 3000);
    EXPECT_GT(nearly_touched, 100) << "the bound is so careful that these sheets say nothing about it";
    EXPECT_GT(refused, 3000U);
}

TEST(FlatBlocks, KeepAFlatSheetApartToNearlyItsRestDistances) {
    const Grid grid{12, 9};
    Points x(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) x.row(p) << spacing * Real(p % 12), 1, -Real(0.2) * Real(p / 12);
    const auto uneven = [&](Real reach) {
        FlatBlocks blocks(grid, spacing, Real(0.2));
        blocks.build(x, std::vector<Real>(static_cast<std::size_t>(grid.particles()), reach), Kernels::Vector);
        return blocks.uneven().size();
    };
    const Real half = apart_at_rest(spacing, Real(0.2)) / 2;
    EXPECT_EQ(uneven(Real(0.999) * half), 0U);
    EXPECT_EQ(uneven(Real(1.001) * half), 10U * 7U);
}

TEST(FlatBlocks, SeeACollapsedBlock) {
    const Grid grid{3, 3};
    const auto is_flat = [&](const Points& x, Kernels kernels) {
        FlatBlocks blocks(grid, spacing, spacing);
        blocks.build(x, std::vector<Real>(9, 0), kernels);
        return blocks.uneven().empty();
    };
    for (const Kernels kernels : both_kinds) EXPECT_FALSE(is_flat(Points::Zero(9, 3), kernels));
    // But for rounding, corners b and c of each cell are in one place
    std::mt19937 random(2);
    std::uniform_real_distribution<Real> unit(0, 1);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 along = Vec3(unit(random), unit(random), unit(random)).normalized() * spacing;
        Points x(9, 3);
        for (int p = 0; p < 9; ++p) x.row(p) = (1 + (p % 3 + p / 3) * along.array()).matrix().transpose();
        EXPECT_FALSE(is_flat(x, both_kinds[trial % 2]));
    }
}

TEST(FlatBlocks, HaveTheSameBitsPlainAndByVectors) {
    std::mt19937 random(9);
    for (const Grid& grid : {Grid{3, 3}, Grid{4, 11}, Grid{29, 7}}) {
        for (int trial = 0; trial < 20; ++trial) {
            const Points x = crumpled(grid, random);
            const std::vector<Real> reaches(static_cast<std::size_t>(grid.particles()), Real(0.01));
            std::vector<Real> plain(static_cast<std::size_t>((grid.nx - 2) * (grid.ny - 2))), vector = plain;
            find_block_room({grid, x, reaches, spacing, Real(0.11)}, plain, Kernels::Plain);
            find_block_room({grid, x, reaches, spacing, Real(0.11)}, vector, Kernels::Vector);
            ASSERT_EQ(plain, vector);
        }
    }
}

}  // namespace
}  // namespace drape
