#include <array>

#include "patch_kernels.h"

namespace drape::kernels {
namespace {

/// A grid that fits an int has no more levels.
constexpr std::size_t most_levels = 32;

struct TreeFit {
    const Grid& grid;
    std::span<const QuadtreeNode> nodes;
    const Points& x;
    std::span<BoundingSphere> spheres;
    std::array<Vec3, most_levels> centres{};  ///< of the node at hand and of those above it, by their levels
    std::array<Real, most_levels> squares{};  ///< of their radii so far

    /// Centres of a node and of all below it.
    PatchSums centre_from(std::size_t n) {
        const QuadtreeNode& node = nodes[n];
        const Patch patch = patch_of(grid, node, x);
        PatchSums sums;
        if (node.children == 0) {
            sums = kernels::sums(patch);
        } else {
            for (int child = 0; child < node.children; ++child) {
                const auto c = static_cast<std::size_t>(node.first_child + child);
                const PatchSums of_child = centre_from(c);
                sums.inner += of_child.inner;
                if (nodes[c].i1 == node.i1) sums.right += of_child.right;
                if (nodes[c].j1 == node.j1) sums.below += of_child.below;
            }
        }
        spheres[n].centre = mean(patch, sums);
        return sums;
    }

    /// Squared radii of a node at some level, of those above it so far, and of all below it.
    void measure(std::size_t n, std::size_t level) {
        const QuadtreeNode& node = nodes[n];
        centres[level] = spheres[n].centre;
        squares[level] = 0;
        if (node.children == 0) {
            raise_to_farthest(patch_of(grid, node, x), centres.data(), static_cast<int>(level) + 1, squares.data());
        } else {
            for (int child = 0; child < node.children; ++child) {
                measure(static_cast<std::size_t>(node.first_child + child), level + 1);
            }
        }
        spheres[n].radius = BoundingSphere::radius_of(squares[level]);
    }
};

}  // namespace

void fit_centroid_tree(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x,
                       std::span<BoundingSphere> spheres) {
    TreeFit fit{grid, nodes, x, spheres};
    fit.centre_from(0);
    fit.measure(0, 0);
}

}  // namespace drape::kernels
