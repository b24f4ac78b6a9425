#pragma once

#include <array>
#include <utility>

/// Symmetric 3 x 3 blocks by their entries xx, xy, xz, yy, yz, zz.
namespace drape {

/// Adds a symmetric block to that of a node.
template <class Blocks, class Block>
void add_block(Blocks& blocks, int node, const Block& block) {
    int entry = 0;
    for (int r = 0; r < 3; ++r) {
        for (int c = r; c < 3; ++c) blocks(node, entry++) += static_cast<typename Blocks::Scalar>(block(r, c));
    }
}

/// z = B r, with a block for each node.
template <class Blocks, class From, class To>
void multiply_blocks(const Blocks& blocks, const From& r, To&& z) {
    z.col(0) = blocks.col(0) * r.col(0) + blocks.col(1) * r.col(1) + blocks.col(2) * r.col(2);
    z.col(1) = blocks.col(1) * r.col(0) + blocks.col(3) * r.col(1) + blocks.col(4) * r.col(2);
    z.col(2) = blocks.col(2) * r.col(0) + blocks.col(4) * r.col(1) + blocks.col(5) * r.col(2);
}

/// The adjugate of a block, and its determinant, by which that is divided to be the inverse.
template <class Number, class Block>
std::pair<std::array<Number, 6>, Number> adjugate_of(const Block& block) {
    const Number xx = block[0], xy = block[1], xz = block[2], yy = block[3], yz = block[4], zz = block[5];
    const Number cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
    return {{cxx, cxy, cxz, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy}, xx * cxx + xy * cxy + xz * cxz};
}

}  // namespace drape
