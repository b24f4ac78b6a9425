#include <bit>
#include <cstring>

#include "contact/contact_geometry.h"
#include "near_cells.h"
#include "touched_triangles.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Each bit of a word followed by a zero.
HWY_INLINE std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffff;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ff;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0f;
    bits = (bits | bits << 2) & 0x3333333333333333;
    return (bits | bits << 1) & 0x5555555555555555;
}

/// @param next where the next number goes; what a vector writes behind the last one does not count
int* list_triangles_of(std::span<const CellBits> near, int* next) {
    const hn::CappedTag<std::int32_t, 16> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto lane = hn::Iota(d, 0);
    const std::uint64_t all = (std::uint64_t{1} << lanes) - 1;
    for (const CellBits& some : near) {
        if ((some.first | some.second) == 0) continue;
        const std::uint64_t set = spread(some.first) | spread(some.second) << 1;
        for (int k = 0; k < 2 * some.count; k += lanes) {
            const std::uint64_t here = set >> k & all;
            std::uint8_t bytes[sizeof here];
            std::memcpy(bytes, &here, sizeof here);  // the lowest first
            hn::StoreU(hn::Compress(hn::Add(lane, hn::Set(d, 2 * some.cell + k)), hn::LoadMaskBits(d, bytes)), d, next);
            next += std::popcount(here);
        }
    }
    return next;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(list_triangles_of);

namespace {

constexpr std::size_t max_lanes = 16;  ///< that a list may be written beyond its end

/// Leaves no triangle open.
void decide(const Grid& grid, const Points& x, const Vec3& p, Real radius, CellBits& bits) {
    const auto touches = [&](int triangle) {
        return (closest_point(x, grid.triangle_corners(triangle), p).point - p).squaredNorm() <= radius * radius;
    };
    for (std::uint32_t open = bits.first_open | bits.second_open; open != 0; open &= open - 1) {
        const int cell = bits.cell + std::countr_zero(open);
        const std::uint32_t bit = open & -open;
        if (bits.first_open & bit && touches(2 * cell)) bits.first |= bit;
        if (bits.second_open & bit && touches(2 * cell + 1)) bits.second |= bit;
    }
}

}  // namespace

void find_touched(const Grid& grid, const Points& x, const Vec3& p, Real radius, std::span<const CellRun> cells,
                  std::vector<int>& triangles) {
    std::size_t found = 0;
    visit_near(grid, x, p, radius, cells, [&](std::span<CellBits> near) {
        std::size_t room = found + max_lanes;
        for (CellBits& bits : near) {
            decide(grid, x, p, radius, bits);
            room += 2 * static_cast<std::size_t>(bits.count);
        }
        // What a former list has left is room too
        if (triangles.size() < room) triangles.resize(room);
        int* const begin = triangles.data();
        found = static_cast<std::size_t>(HWY_DYNAMIC_DISPATCH(list_triangles_of)(near, begin + found) - begin);
    });
    triangles.resize(found);
}

}  // namespace drape::kernels
#endif
