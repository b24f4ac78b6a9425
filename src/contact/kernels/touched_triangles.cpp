#include "ball_contacts.h"
#include "closest_points.h"
#include "near_cells.h"

namespace drape::kernels {
namespace {

/// Turns the open bits of cells into answers.
class Decision {
public:
    Decision(const Grid& grid, const Points& x, const Vec3& p, Real radius)
        : grid_(grid), x_(x), p_(p), square_(radius * radius) {}

    void decide(std::span<CellBits> cells) {
        for (CellBits& bits : cells) {
            for_each_set(grid_, bits, bits.open(), [&](int cell, int a) {
                asker_[batch_.count] = &bits;
                batch_.add(grid_, x_, cell, a);
                if (batch_.full()) settle();
            });
        }
        settle();
    }

private:
    void settle() {
        find_closest_points(batch_, p_);
        for (std::size_t k = 0; k < batch_.count; ++k) {
            const int bit = batch_.cell[k] - asker_[k]->cell;
            asker_[k]->first |= (batch_.closest[0].square[k] <= square_ ? 1u : 0u) << bit;
            asker_[k]->second |= (batch_.closest[1].square[k] <= square_ ? 1u : 0u) << bit;
        }
        batch_.count = 0;
    }

    const Grid& grid_;
    const Points& x_;
    const Vec3& p_;
    Real square_;
    CellBatch batch_;
    std::array<CellBits*, CellBatch::size> asker_{};
};

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
        if (std::ranges::any_of(near, [](const CellBits& bits) { return bits.open() != 0; })) {
            Decision(grid, x, p, radius).decide(near);
        }
        for (const CellBits& bits : near) append(bits, triangles);
    });
}

}  // namespace drape::kernels
