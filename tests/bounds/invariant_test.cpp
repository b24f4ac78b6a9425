// Every node of every tree contains every particle below it, in every frame and by every update.

#include <gtest/gtest.h>

#include "drape/bounds/limited_quadtree.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::breaches;

const Grid invariant_shapes[] = {{2, 2}, {2, 300}, {31, 17}, {257, 257}};

/// A cloth that moves: one half at a time, so that a refit leaves something, from slowly to fast.
class MovingCloth {
public:
    explicit MovingCloth(const Grid& grid)
        : grid_(grid),
          random_(static_cast<unsigned>(grid.particles())),
          x(test::random_cloth(grid, random_)),
          to_(test::random_cloth(grid, random_)) {}

    void move(int frame) {
        const Real fraction = std::pow(Real(10), static_cast<Real>(frame % 5 - 4));
        const int half = grid_.particles() / 2;
        const int first = frame % 2 == 0 ? 0 : half;
        x.middleRows(first, half) += fraction * (to_ - x).middleRows(first, half);
    }

private:
    Grid grid_;
    std::mt19937 random_;

public:
    Points x;

private:
    Points to_;
};

template <class V>
class Invariant : public ::testing::Test {
protected:
    using Tree = ClothQuadtree<V>;
    static int breaches_of(const Grid& grid, const Tree& tree, const std::vector<V>& volumes, const Points& x) {
        return breaches<V>(grid, tree.nodes(), volumes, tree.slack(), x);
    }
};

TYPED_TEST_SUITE(Invariant, test::AllVolumes, test::VolumeNames);

TYPED_TEST(Invariant, HoldsInEveryFrameByEveryUpdate) {
    for (const Grid& grid : invariant_shapes) {
        const bool large = grid.particles() > 10'000;
        for (const UpdateKind update : test::all_updates()) {
            for (const Kernels kernels : {Kernels::Vector, Kernels::Plain}) {
                MovingCloth cloth(grid);
                ClothQuadtree<TypeParam> tree(grid,
                                              {.update = update, .leaf_cells = large ? 16 : 3, .kernels = kernels});
                for (int frame = 0; frame < (large ? 6 : 10); ++frame) {
                    tree.build(cloth.x);
                    ASSERT_EQ(this->breaches_of(grid, tree, tree.volumes(), cloth.x), 0)
                        << grid.nx << " x " << grid.ny << ", update " << static_cast<int>(update) << ", frame " << frame
                        << ", kernels " << static_cast<int>(kernels);
                    cloth.move(frame + 3);
                }
            }
        }
    }
}

/// The nodes at which a search ends are taken as spheres: they make up for a stale tree too.
TYPED_TEST(Invariant, HoldsForTheSpheresThatASearchEndsAt) {
    const Grid grid{31, 17};
    for (const UpdateKind update : test::all_updates()) {
        MovingCloth cloth(grid);
        LimitedQuadtree<TypeParam> tree(grid, {.update = update, .leaf_cells = 3, .search = {.level = 2}});
        Candidates found;
        for (int frame = 0; frame < 10; ++frame) {
            cloth.move(frame);
            tree.build(cloth.x);
            tree.query({.centre = Vec3::Zero(), .radius = 99}, found);
            ASSERT_EQ(found.stopped.size(), 16u);
            for (const StoppedNode& node : found.stopped) {
                const Patch patch = patch_of(grid, node, cloth.x);
                EXPECT_LE(test::farthest_out(node.sphere, patch), 1e-12L) << static_cast<int>(update);
            }
        }
    }
}

TYPED_TEST(Invariant, IsSeenBrokenByAStaleParent) {
    const Grid grid{31, 17};
    MovingCloth cloth(grid);
    ClothQuadtree<TypeParam> tree(grid);
    tree.build(cloth.x);
    const TypeParam stale = tree.volumes()[0];
    for (int frame = 0; frame < 10; ++frame) cloth.move(frame);
    cloth.x *= 1.01;
    tree.build(cloth.x);
    std::vector<TypeParam> volumes = tree.volumes();
    EXPECT_EQ(this->breaches_of(grid, tree, volumes, cloth.x), 0);
    volumes[0] = stale;
    EXPECT_EQ(this->breaches_of(grid, tree, volumes, cloth.x), 1);
}

template <class V>
V fit_without_last_row(const Patch& patch) {
    Patch short_patch = patch;
    --short_patch.rows;
    return V::fit(short_patch);
}

TYPED_TEST(Invariant, IsSeenBrokenByAnOffByOneInTheLeafRange) {
    const Grid grid{31, 17};
    const MovingCloth cloth(grid);
    ClothQuadtree<TypeParam> tree(grid, {.update = UpdateKind::Merge}, {.patch = fit_without_last_row<TypeParam>});
    tree.build(cloth.x);
    EXPECT_GT(this->breaches_of(grid, tree, tree.volumes(), cloth.x), 10);
}

/// Fitted to particles drawn together by a millionth.
template <class V>
V fit_shrunken(const Patch& patch) {
    Points x(patch.particles(), 3);
    for (int p = 0; p < patch.particles(); ++p) x.row(p) = patch.at(p % patch.columns, p / patch.columns).transpose();
    const Eigen::Matrix<Real, 1, 3> middle = x.colwise().mean();
    x = ((x.rowwise() - middle) * (1 - 1e-6)).eval().rowwise() + middle;
    return V::fit(test::whole(x, {patch.columns, patch.rows}));
}

TYPED_TEST(Invariant, IsSeenBrokenByNodesAMillionthTooSmall) {
    const Grid grid{31, 17};
    const MovingCloth cloth(grid);
    ClothQuadtree<TypeParam> tree(grid, {}, {.patch = fit_shrunken<TypeParam>});
    tree.build(cloth.x);
    EXPECT_EQ(this->breaches_of(grid, tree, tree.volumes(), cloth.x), static_cast<int>(tree.nodes().size()));
}

}  // namespace
}  // namespace drape
