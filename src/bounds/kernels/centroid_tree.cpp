#include <array>

#include "patch_kernels.h"

namespace drape::kernels {
namespace {

/// A grid that fits an int has no more levels.
constexpr std::size_t most_levels = 32;

class TreeFit {
public:
    TreeFit(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x, std::span<BoundingSphere> spheres)
        : grid_(grid), nodes_(nodes), x_(x), spheres_(spheres) {}

    /// Centres of a node and of all below it.
    PatchSums centre_from(std::size_t n) {
        const QuadtreeNode& node = nodes_[n];
        const Patch patch = patch_of(grid_, node, x_);
        PatchSums sums;
        if (node.children == 0) {
            sums = kernels::sums(patch);
        } else {
            for (int child = 0; child < node.children; ++child) {
                const auto c = static_cast<std::size_t>(node.first_child + child);
                const PatchSums of_child = centre_from(c);
                sums.inner += of_child.inner;
                if (nodes_[c].i1 == node.i1) sums.right += of_child.right;
                if (nodes_[c].j1 == node.j1) sums.below += of_child.below;
            }
        }
        spheres_[n].centre = mean(patch, sums);
        return sums;
    }

    /// Squared radii of a node at some level, of those above it so far, and of all below it.
    void measure(std::size_t n, std::size_t level) {
        const QuadtreeNode& node = nodes_[n];
        centres_[level] = spheres_[n].centre;
        squares_[level] = 0;
        if (node.children == 0) {
            raise_to_farthest(patch_of(grid_, node, x_), centres_.data(), static_cast<int>(level) + 1, squares_.data());
        } else {
            for (int child = 0; child < node.children; ++child) {
                measure(static_cast<std::size_t>(node.first_child + child), level + 1);
            }
        }
        spheres_[n].radius = BoundingSphere::radius_of(squares_[level]);
    }

private:
    const Grid& grid_;
    std::span<const QuadtreeNode> nodes_;
    const Points& x_;
    std::span<BoundingSphere> spheres_;
    std::array<Vec3, most_levels> centres_;
    std::array<Real, most_levels> squares_{};
};

}  // namespace

void fit_centroid_tree(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x,
                       std::span<BoundingSphere> spheres) {
    TreeFit fit(grid, nodes, x, spheres);
    fit.centre_from(0);
    fit.measure(0, 0);
}

}  // namespace drape::kernels
