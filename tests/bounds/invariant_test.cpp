// Every node of every tree contains every particle below it, in every frame and by every update.

#include <gtest/gtest.h>

#include "drape/bounds/cloth_quadtree.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

const Grid invariant_shapes[] = {{2, 2}, {2, 300}, {31, 17}, {130, 70}};

/// A cloth that moves: one half at a time, so that a refit leaves something, from slowly to fast.
struct MovingCloth {
    std::mt19937 random;
    Points x, to;

    explicit MovingCloth(const Grid& grid)
        : random(static_cast<unsigned>(grid.particles())),
          x(test::random_cloth(grid, random)),
          to(test::random_cloth(grid, random)) {}

    void move(int frame) {
        const Real fraction = std::pow(Real(10), static_cast<Real>(frame % 5 - 4));
        const Eigen::Index half = x.rows() / 2, first = frame % 2 == 0 ? 0 : half;
        x.middleRows(first, half) += fraction * (to - x).middleRows(first, half);
    }
};

template <class V>
class Invariant : public ::testing::Test {};

TYPED_TEST_SUITE(Invariant, test::AllVolumes, test::VolumeNames);

TYPED_TEST(Invariant, HoldsInEveryFrameByEveryUpdate) {
    for (const Grid& grid : invariant_shapes) {
        const bool large = grid.particles() > 5'000;
        for (const UpdateKind update : values_of<UpdateKind>()) {
            for (const Kernels kernels : {Kernels::Vector, Kernels::Plain}) {
                MovingCloth cloth(grid);
                ClothQuadtree<TypeParam> tree(grid,
                                              {.update = update, .leaf_cells = large ? 16 : 3, .kernels = kernels});
                for (int frame = 0; frame < (large ? 6 : 10); ++frame) {
                    tree.build(cloth.x);
                    ASSERT_EQ(test::breaches<TypeParam>(grid, tree.nodes(), tree.volumes(), tree.slack(), cloth.x), 0)
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
    for (const UpdateKind update : values_of<UpdateKind>()) {
        MovingCloth cloth(grid);
        ClothQuadtree<TypeParam> tree(grid, {.update = update, .leaf_cells = 3, .search = {.level = 2}});
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

}  // namespace
}  // namespace drape
