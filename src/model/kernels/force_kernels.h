#pragma once

#include <array>
#include <functional>
#include <vector>

#include "drape/model/force_sweep.h"

/// The loop over springs, vectorised for several generations of processors, of which the best that there is gets chosen
/// at run time. Every particle's sum is made in one order with exact roots and quotients: the bits are the same on all.
namespace drape::kernels {

/// What the forces depend on, by coordinate.
struct ForceInput {
    const ClothModel* model;
    std::array<const Real*, 3> x;     ///< [m]
    std::array<const Real*, 3> v;     ///< [m/s]
    std::array<const Real*, 3> wind;  ///< [N], of every particle; null if there is none
};

/// One row a coordinate.
using Rows = std::array<Real*, 3>;

/// The rows of numbers that a sweep over some rows of the cloth works in. Rows of the cloth, which may lie apart by a
/// power of two and then drive each other out of the cache, are copied here. Particles that the cloth does not have are
/// zero.
struct ForceScratch {
    static constexpr int margin = 16;  ///< columns on both sides that springs and the last vector extend into

    Grid grid;
    int first_row, end_row;  ///< the rows swept are first_row to end_row - 1
    int length;              ///< of each row of numbers

    ForceScratch(const Grid& cloth, int first, int end);

    /// A row of particles, of which three follow one another and two after the last one stay.
    [[nodiscard]] Rows x(int row) { return three(9 * slot(row)); }
    [[nodiscard]] Rows v(int row) { return three(9 * slot(row) + 3); }
    [[nodiscard]] Rows wind(int row) { return three(9 * slot(row) + 6); }

    /// Of the springs of one kind with first ends in a row, by the column of that end; three rows are kept, which hold
    /// what they held before until they are found.
    [[nodiscard]] Rows pulls(int kind, int row) { return three(45 + 9 * kind + (row + 3) % 3 * 3); }

    /// Of each kind, by the column of the first end: 1 if there is a column for the second end, else 0.
    [[nodiscard]] Real* there(int kind) { return row_of(99 + kind); }
    [[nodiscard]] Real* zeros() { return row_of(105); }
    [[nodiscard]] Rows force() { return three(106); }

private:
    static constexpr int rows = 109;

    /// Numbers that lie in one line of the cache: what vectors are best loaded from.
    struct alignas(64) CacheLine {
        static constexpr int numbers = 64 / sizeof(Real);
        Real values[numbers];
    };

    [[nodiscard]] int slot(int row) const { return row < end_row ? row % 3 : 3 + row - end_row; }
    [[nodiscard]] Real* row_of(int number) { return memory_.data()->values + number * length; }
    [[nodiscard]] Rows three(int number) { return {row_of(number), row_of(number + 1), row_of(number + 2)}; }

    std::vector<CacheLine> memory_;
};

/// As `drape::add_wind_forces`, cell by cell.
void add_wind_forces(const ClothModel& model, const Points& x, const Points& v, Points& f);

/// Copies what other parts may overwrite while this one is swept: the rows next to it.
void copy_neighbours(const ForceInput& input, ForceScratch& scratch);

/// Calls use(run) for each row of a part; what it reads of the part's particles is read before their run is used.
/// @pre the scratch has the neighbours as they are
void forces_on(const ForceInput& input, ForceScratch& scratch, const std::function<void(const ForceRun&)>& use);

}  // namespace drape::kernels
