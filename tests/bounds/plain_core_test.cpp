// The vector kernels are held to the plain core: every fit of every volume, on patches of every shape; and to each
// other on every kind of vector that this processor has, and on none.

#include <gtest/gtest.h>

#include "drape/bounds/cloth_quadtree.h"
#include "support/cloths.h"
#include "support/containment.h"
#include "support/point_sets.h"
#include "support/vector_kinds.h"

namespace drape {
namespace {

/// How far two volumes are apart [m].
Real difference(const BoundingSphere& a, const BoundingSphere& b) {
    return (a.centre - b.centre).norm() + std::abs(a.radius - b.radius);
}
Real difference(const Aabb& a, const Aabb& b) { return (a.low - b.low).norm() + (a.high - b.high).norm(); }
Real difference(const Obb& a, const Obb& b) {
    return (a.origin - b.origin).norm() + (a.axes - b.axes).norm() + (a.low - b.low).norm() + (a.high - b.high).norm();
}
template <int K>
Real difference(const KDop<K>& a, const KDop<K>& b) {
    Real sum = difference(a.box, b.box);
    for (std::size_t k = 0; k < KDop<K>::cuts; ++k)
        sum += std::abs(a.low[k] - b.low[k]) + std::abs(a.high[k] - b.high[k]);
    return sum;
}

/// Patches within a larger grid: a row, a column, squares, odd and wide ones; cloth, and points that coincide or are in
/// one line or plane; at several scales.
template <class Visit>
void for_many_scaled_patches(Visit visit) {
    std::mt19937 random(51);
    constexpr std::pair<int, int> shapes[] = {{2, 1},  {17, 1}, {1, 2},  {1, 13}, {2, 2},  {3, 2},  {2, 3},
                                              {5, 5},  {7, 3},  {8, 8},  {9, 16}, {15, 4}, {16, 2}, {17, 5},
                                              {31, 3}, {40, 2}, {64, 1}, {65, 2}, {2, 40}};
    for (const auto& shape : shapes) {
        const int columns = shape.first, rows = shape.second;
        const Grid grid{columns + 3, rows + 2};
        const auto visit_scaled = [&](const Points& x) {
            for (const Real scale : {Real(1e-6), Real(1), Real(1e6)}) {
                const Points scaled = scale * x;
                const Real* const first = scaled.data() + grid.particle(1, 1);
                visit(Patch{first, first + x.rows(), first + 2 * x.rows(), columns, rows, grid.nx}, scale);
            }
        };
        for (int round = 0; round < 8; ++round) visit_scaled(test::random_cloth(grid, random));
        for (const test::PointSet& set : test::point_sets()) {
            visit_scaled(test::random_points(set, grid.particles(), random));
        }
    }
}

/// Patches on which two fits differ by more than the rounding.
template <class Volume>
int disagreements(Volume (*a)(const Patch&), Volume (*b)(const Patch&), Real tolerance) {
    int count = 0;
    for_many_scaled_patches(
        [&](const Patch& patch, Real scale) { count += !(difference(a(patch), b(patch)) <= tolerance * scale); });
    return count;
}

template <class V>
class PlainCore : public ::testing::Test {};

using OneFit = ::testing::Types<Aabb, KDop<6>, KDop<14>, KDop<18>, KDop<26>, Obb>;
TYPED_TEST_SUITE(PlainCore, OneFit, test::VolumeNames);

TYPED_TEST(PlainCore, FitsWhatTheKernelFits) {
    const auto vector = fits_of<TypeParam>({}).patch, plain = fits_of<TypeParam>({.kernels = Kernels::Plain}).patch;
    EXPECT_NE(vector, plain);
    EXPECT_EQ(disagreements<TypeParam>(vector, plain, Real(1e-13)), 0);
}

/// The setting is obeyed: every node has the plain fit, to the bit, or up to a tolerance [m].
template <class V>
int nodes_with_another_fit(const BroadPhaseParameters& parameters, const Grid& grid = {31, 17}, Real tolerance = 0) {
    std::mt19937 random(53);
    const Points x = test::random_cloth(grid, random);
    ClothQuadtree<V> tree(grid, parameters);
    tree.build(x);
    int others = 0;
    for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
        others += !(difference(tree.volumes()[n], V::fit(patch_of(grid, tree.nodes()[n], x))) <= tolerance);
    }
    return others;
}

TYPED_TEST(PlainCore, FitsEveryNodeOfATreeThatIsToBePlain) {
    EXPECT_EQ(nodes_with_another_fit<TypeParam>({.leaf_cells = 3, .kernels = Kernels::Plain}), 0);
}

TEST(PlainTree, HasTheCentroidSphereOfEachNodeAndTheVectorTreeOneThatIsRounded) {
    EXPECT_EQ(nodes_with_another_fit<BoundingSphere>({.leaf_cells = 3, .kernels = Kernels::Plain}), 0);
    EXPECT_GT(nodes_with_another_fit<BoundingSphere>({.leaf_cells = 3}), 20);
}

/// Calls visit(grid, leaf_cells) for many leaves in a row, narrow ones at the sides, a grid so wide that its rows are
/// taken by fours, and leaves of one row of cells.
template <class Visit>
void for_many_trees(Visit visit) {
    for (const Grid& grid : {Grid{2, 2}, Grid{31, 17}, Grid{250, 9}, Grid{300, 23}, Grid{2, 300}}) {
        for (const int leaf_cells : {1, 3, 5, 8, 15, 20}) {
            SCOPED_TRACE(std::to_string(grid.nx) + " x " + std::to_string(grid.ny) + ", leaves of " +
                         std::to_string(leaf_cells));
            visit(grid, leaf_cells);
        }
    }
}

TEST(BoxTree, HasThePlainBoxOfEveryNodeThoughItsLeavesAreFittedAtOnce) {
    for_many_trees([](const Grid& grid, int leaf_cells) {
        const BroadPhaseParameters merged{.update = UpdateKind::Merge, .leaf_cells = leaf_cells};
        EXPECT_EQ(nodes_with_another_fit<Aabb>(merged, grid), 0);
    });
}

TEST(CentroidTree, HasThePlainSphereOfEveryNodeUpToRoundingThoughAllAreFittedInOnePass) {
    for_many_trees([](const Grid& grid, int leaf_cells) {
        EXPECT_EQ(nodes_with_another_fit<BoundingSphere>({.leaf_cells = leaf_cells}, grid, Real(1e-12)), 0);
    });
}

/// The volumes of all nodes.
template <class V>
std::vector<V> volumes_of(const Grid& grid, const BroadPhaseParameters& parameters) {
    std::mt19937 random(54);
    ClothQuadtree<V> tree(grid, parameters);
    tree.build(test::random_cloth(grid, random));
    return tree.volumes();
}

template <class V>
class EveryKindOfVector : public ::testing::Test {};

TYPED_TEST_SUITE(EveryKindOfVector, test::UnlikeVolumes, test::VolumeNames);

/// Nodes of all widths up to three vectors, with their neighbours in memory; leaves as wide, of which trees are one.
TYPED_TEST(EveryKindOfVector, GivesEveryNodeTheSameBits) {
    for (int columns = 2; columns <= 40; ++columns) {
        const Grid grid{columns, 17};
        for (const UpdateKind update : {UpdateKind::Rebuild, UpdateKind::Merge}) {
            for (const int leaf_cells : {3, 64}) {
                const BroadPhaseParameters parameters{.update = update, .leaf_cells = leaf_cells};
                const auto best = volumes_of<TypeParam>(grid, parameters);
                const int kinds = test::with_every_kind_of_vector([&](const char* kind) {
                    const auto volumes = volumes_of<TypeParam>(grid, parameters);
                    for (std::size_t n = 0; n < best.size(); ++n) {
                        ASSERT_EQ(difference(volumes[n], best[n]), 0) << kind << ", " << columns << " columns";
                    }
                });
                ASSERT_GE(kinds, 2) << "this processor has no vectors to compare with";
            }
        }
    }
}

TEST(PlainSphere, IsWhatTheKernelFits) {
    for (const SphereFit fit : {SphereFit::Centroid, SphereFit::BoxCentre}) {
        const auto vector = sphere_fit_of(fit, Kernels::Vector), plain = sphere_fit_of(fit, Kernels::Plain);
        EXPECT_NE(vector, plain);
        EXPECT_EQ(disagreements<BoundingSphere>(vector, plain, Real(1e-12)), 0) << name_of(fit);
    }
}

TEST(Displacement, IsThatOfTheParticleThatHasGoneFarthest) {
    std::mt19937 random(52);
    for (const Grid& grid : {Grid{2, 2}, Grid{31, 17}, Grid{2, 100}}) {
        const Points x = test::random_cloth(grid, random), before = test::random_cloth(grid, random);
        EXPECT_NEAR(largest_displacement(x, before), (x - before).rowwise().norm().maxCoeff(), 1e-14);
    }
}

}  // namespace
}  // namespace drape
