#pragma once

#include <array>
#include <cstddef>

namespace drape::kernels {

/// Symmetric stencils of 3 x 3 blocks, single precision, as multigrid has them: of each node, 13 blocks that join it
/// with itself and with nodes after it, each with xx, xy, xz, yy, yz, zz. Nodes stand by sixteens, the same number of
/// all of them beside each other.
struct StencilLayout {
    static constexpr int blocks = 13, entries = 6, group = 16;

    /// How many numbers the stencils of nodes are.
    static std::size_t numbers(int nodes) {
        return static_cast<std::size_t>((nodes + group - 1) / group) * blocks * entries * group;
    }

    /// The first of a block's entries; the others follow, each a group later.
    static std::ptrdiff_t first_entry(int node, int block) {
        return (static_cast<std::ptrdiff_t>(node / group) * blocks + block) * entries * group + node % group;
    }
};

/// y = A u.
/// @param shifts of each block, from a node to the other that it joins; not above 0 but for the first: there is none
/// @param u, y nodes x 3, coordinate by coordinate
void multiply_stencils(const float* stencils, int nodes, const std::array<int, StencilLayout::blocks>& shifts,
                       const float* u, float* y);

}  // namespace drape::kernels
