#include "ball_contacts.h"
#include "contact/contact_geometry.h"
#include "near_cells.h"

namespace drape::kernels {
namespace {

void decide(const Grid& grid, const Points& x, const Vec3& p, Real radius, CellBits& bits) {
    const auto touches = [&](int triangle) {
        return (closest_point(x, grid.triangle_corners(triangle), p).point - p).squaredNorm() <= radius * radius;
    };
    for (std::uint32_t undecided = bits.undecided; undecided != 0; undecided &= undecided - 1) {
        const int k = std::countr_zero(undecided), cell = bits.cell + k;
        const std::uint32_t bit = 1u << k;
        if (!(bits.first & bit) && touches(2 * cell)) bits.first |= bit;
        if (!(bits.second & bit) && touches(2 * cell + 1)) bits.second |= bit;
    }
}

void append(const CellBits& bits, std::vector<int>& triangles) {
    const std::size_t before = triangles.size();
    triangles.resize(before + 2 * static_cast<std::size_t>(bits.count));
    int* next = triangles.data() + before;
    if ((bits.first & bits.second) == (1u << bits.count) - 1) {
        for (int k = 0; k < 2 * bits.count; ++k) next[k] = 2 * bits.cell + k;
        return;
    }
    for (int k = 0; k < bits.count; ++k) {
        *next = 2 * (bits.cell + k);
        next += bits.first >> k & 1u;
        *next = 2 * (bits.cell + k) + 1;
        next += bits.second >> k & 1u;
    }
    triangles.resize(static_cast<std::size_t>(next - triangles.data()));
}

}  // namespace

void find_touched(const Grid& grid, const Points& x, const Vec3& p, Real radius, std::span<const CellRun> cells,
                  std::vector<int>& triangles) {
    visit_near(grid, x, p, radius, cells, [&](std::span<CellBits> near) {
        for (CellBits& bits : near) {
            decide(grid, x, p, radius, bits);
            append(bits, triangles);
        }
    });
}

}  // namespace drape::kernels
