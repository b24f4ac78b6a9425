#include "drape/contact/flat_blocks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact_geometry.h"
#include "kernels/flat_blocks.h"

namespace drape {
namespace {

/// From x to z, as the kernel does.
Real dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

/// The room of the block around a particle.
Real room_around(const BlockRoom& of, int middle) {
    const int nx = of.grid.nx;
    const auto at = [&](int row, int column) { return position(of.x, middle + row * nx + column); };
    const Real to_along = 1 / of.hx, to_across = 1 / of.hy;
    const Vec3 along = (at(0, 1) - at(0, -1)) * (to_along / 2), across = (at(1, 0) - at(-1, 0)) * (to_across / 2);
    const Vec3 normal = along.cross(across);
    const Real normal_square = dot(normal, normal), of_square = 1 / normal_square;
    // The squares of the largest deviations within the plane; never by a difference of squares, which would lose half
    // of the digits
    Real of_along = 0, of_across = 0;
    const auto raise = [&](Real& most, const Vec3& deviation) {
        const Vec3 within = deviation - normal * (dot(deviation, normal) * of_square);
        most = std::max(most, dot(within, within));
    };
    for (const int k : {-1, 0, 1}) {
        for (const int from : {-1, 0}) {
            raise(of_along, (at(k, from + 1) - at(k, from)) * to_along - along);
            raise(of_across, (at(from + 1, k) - at(from, k)) * to_across - across);
        }
    }
    Real reach = 0;
    for (const int row : {-1, 0, 1}) {
        for (const int column : {-1, 0, 1}) {
            reach = std::max(reach, of.reaches[static_cast<std::size_t>(middle + row * nx + column)]);
        }
    }
    const Real a = dot(along, along), b = dot(across, across), ab = dot(along, across);
    const Real larger = (a + b + std::sqrt((a - b) * (a - b) + 4 * ab * ab)) / 2;
    const Real rounding = block_rounding * (1 + std::sqrt(larger));
    const Real least = std::sqrt(normal_square / larger) - std::sqrt(of_along + of_across) - rounding;
    return normal_square > 0 ? least * apart_at_rest(of.hx, of.hy) - 2 * reach : Real(-1);
}

}  // namespace

FlatBlocks::FlatBlocks(const Grid& grid, Real hx, Real hy) : grid_(grid), hx_(hx), hy_(hy) {
    room_.resize(static_cast<std::size_t>(columns() * rows()), Real(-1));
    uneven_.resize(room_.size());
    std::iota(uneven_.begin(), uneven_.end(), 0);
}

void FlatBlocks::build(const Points& x, std::span<const Real> reaches, Kernels kernels) {
    const bool is_strip = grid_.nx < 3 || grid_.ny < 3;
    if (!is_strip) find_block_room({grid_, x, reaches, hx_, hy_}, room_, kernels);
    uneven_.clear();
    for (std::size_t block = 0; block < room_.size(); ++block) {
        if (!(room_[block] > 0)) uneven_.push_back(static_cast<int>(block));
    }
}

void find_block_room(const BlockRoom& of, std::span<Real> room, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::find_block_room(of, room);
    std::size_t block = 0;
    for (int j = 1; j + 1 < of.grid.ny; ++j) {
        for (int i = 1; i + 1 < of.grid.nx; ++i) room[block++] = room_around(of, of.grid.particle(i, j));
    }
}

}  // namespace drape
