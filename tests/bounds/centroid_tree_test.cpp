#include <gtest/gtest.h>

#include "bounds/kernels/patch_kernels.h"
#include "drape/bounds/sphere_fits.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// Compares all spheres of a tree that was fitted in one pass with those fitted node by node.
void compare_with_single_fits(const Grid& grid, int leaf_cells, const Points& x) {
    const auto nodes = make_quadtree_nodes(grid, leaf_cells);
    std::vector<BoundingSphere> spheres(nodes.size());
    kernels::fit_centroid_tree(grid, nodes, x, spheres);
    const Real size = x.cwiseAbs().maxCoeff();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Patch patch = patch_of(grid, nodes[n], x);
        const BoundingSphere single = sphere_fit_of(SphereFit::Centroid, Kernels::Vector)(patch);
        ASSERT_LE((spheres[n].centre - single.centre).norm(), 1e-14 * size) << "node " << n;

        // To the bit: the farthest particle from the centre that the tree has
        Real square = 0;
        for (int j = 0; j < patch.rows; ++j) {
            for (int i = 0; i < patch.columns; ++i) {
                const Vec3 d = patch.at(i, j) - spheres[n].centre;
                square = std::max(square, (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2]);
            }
        }
        ASSERT_EQ(spheres[n].radius, BoundingSphere::radius_of(square)) << "node " << n;
    }
}

TEST(CentroidTree, FitsEveryNodeToAllOfItsParticles) {
    std::mt19937 random(11);
    for (const Grid& grid : {Grid{2, 2}, Grid{2, 300}, Grid{300, 2}, Grid{31, 17}, Grid{30, 30}, Grid{257, 257}}) {
        for (const int leaf_cells : {1, 3, 4, 7, 15, 20}) {
            SCOPED_TRACE(std::to_string(grid.nx) + " x " + std::to_string(grid.ny) + ", leaf " +
                         std::to_string(leaf_cells));
            compare_with_single_fits(grid, leaf_cells, test::random_cloth(grid, random));
        }
    }
    // At any scale, and for a cloth that is a point or a line
    const Grid grid{31, 17};
    const Points x = test::random_cloth(grid, random);
    compare_with_single_fits(grid, 7, 1e6 * x);
    compare_with_single_fits(grid, 7, 1e-6 * x);
    compare_with_single_fits(grid, 7, Points::Constant(grid.particles(), 3, 0.1));
    Points line = Points::Zero(grid.particles(), 3);
    line.col(1) = x.col(1);
    compare_with_single_fits(grid, 7, line);
}

}  // namespace
}  // namespace drape
