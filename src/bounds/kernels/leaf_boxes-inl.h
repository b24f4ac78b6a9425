#include <array>
#include <limits>

#include "patch_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Leaves side by side in the same rows, with as many columns each.
struct LeafGroup {
    static constexpr std::size_t most = 40;

    std::span<const int> leaves;
    std::array<Patch, most> patches;
};

/// The leaves at the beginning of a list that are such a group.
HWY_INLINE void take_group(const Grid& grid, std::span<const QuadtreeNode> nodes, std::span<const int> leaves,
                           const Points& x, LeafGroup& group) {
    const std::size_t limit = HWY_MIN(leaves.size(), LeafGroup::most);
    std::size_t count = 0;
    for (; count < limit; ++count) {
        const QuadtreeNode& leaf = nodes[static_cast<std::size_t>(leaves[count])];
        group.patches[count] = patch_of(grid, leaf, x);
        const Patch &first = group.patches[0], &last = group.patches[count];
        const bool beside = leaf.j0 == nodes[static_cast<std::size_t>(leaves[0])].j0;
        if (!beside || last.columns != first.columns || last.rows != first.rows) break;
    }
    group.leaves = leaves.first(count);
}

/// A few rows of all leaves of a group, then a few more: whole lines of memory, one after the other.
template <class D>
HWY_INLINE void fit_group(D d, const LeafGroup& group, std::span<Aabb> boxes) {
    using V = hn::Vec<D>;
    constexpr std::size_t lanes = hn::MaxLanes(D());
    // Rows of a small cloth stay in the cache until they are all seen
    const int rows = group.patches[0].rows, rows_at_once = group.patches[0].stride < 256 ? rows : 4;
    HWY_ALIGN Real extents[LeafGroup::most][6][lanes];  // what each lane has seen
    const V infinity = hn::Set(d, std::numeric_limits<Real>::infinity());
    for (int j = 0; j < rows; j += rows_at_once) {
        for (std::size_t k = 0; k < group.leaves.size(); ++k) {
            auto& seen = extents[k];
            const Patch& all = group.patches[k];
            const int skipped = j * all.stride;
            const Patch some{
                all.x + skipped, all.y + skipped, all.z + skipped, all.columns, HWY_MIN(rows_at_once, rows - j),
                all.stride};
            V least[3], most[3];
            for (int axis = 0; axis < 3; ++axis) {
                least[axis] = j == 0 ? infinity : hn::Load(d, seen[axis]);
                most[axis] = j == 0 ? hn::Neg(infinity) : hn::Load(d, seen[3 + axis]);
            }
            for_each_vector(d, some, [&](int i, int row) HWY_ATTR {
                const int p = row * some.stride + i;
                const V x = loaded_once(hn::LoadU(d, some.x + p)), y = loaded_once(hn::LoadU(d, some.y + p)),
                        z = loaded_once(hn::LoadU(d, some.z + p));
                least[0] = hn::Min(least[0], x), most[0] = hn::Max(most[0], x);
                least[1] = hn::Min(least[1], y), most[1] = hn::Max(most[1], y);
                least[2] = hn::Min(least[2], z), most[2] = hn::Max(most[2], z);
            });
            Aabb& box = boxes[static_cast<std::size_t>(group.leaves[k])];
            const bool done = j + rows_at_once >= rows;
            for (int axis = 0; axis < 3; ++axis) {
                if (done) {
                    box.low[axis] = smallest_lane(d, least[axis]);
                    box.high[axis] = largest_lane(d, most[axis]);
                } else {
                    hn::Store(least[axis], d, seen[axis]);
                    hn::Store(most[axis], d, seen[3 + axis]);
                }
            }
        }
    }
}

void fit_leaf_boxes_of(const Grid& grid, std::span<const QuadtreeNode> nodes, std::span<const int> leaves,
                       const Points& x, std::span<Aabb> boxes) {
    LeafGroup group;
    while (!leaves.empty()) {
        take_group(grid, nodes, leaves, x, group);
        with_vectors_for(group.patches[0].columns, [&](auto d) HWY_ATTR { fit_group(d, group, boxes); });
        leaves = leaves.subspan(group.leaves.size());
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(fit_leaf_boxes_of);

void fit_leaf_boxes(const Grid& grid, std::span<const QuadtreeNode> nodes, std::span<const int> leaves, const Points& x,
                    std::span<Aabb> boxes) {
    HWY_DYNAMIC_DISPATCH(fit_leaf_boxes_of)(grid, nodes, leaves, x, boxes);
}

}  // namespace drape::kernels
#endif
