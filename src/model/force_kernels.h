#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

#include "drape/model/force_sweep.h"

/// The loop over springs, vectorised for several generations of processors, of which the best that there is gets chosen
/// at run time. Every particle's sum is made in one order with exact roots and quotients: the bits are the same on all.
namespace drape::kernels {

/// What the forces depend on; three pointers are one a coordinate.
struct ForceInput {
    const ClothModel* model;
    const Real* x[3];     ///< [m]
    const Real* v[3];     ///< [m/s]
    const Real* wind[3];  ///< [N], of every particle; null if there is none
};

/// A rectangle of particles.
struct Part {
    int first_column, columns, first_row, rows;
};

/// The rows of numbers that a sweep over a part works in. Rows of the cloth, which may lie apart by a power of two and
/// then drive each other out of the cache, are copied here. Particles that the cloth does not have are zero.
class Scratch {
public:
    static constexpr int margin = 16;  ///< columns on both sides that springs and the last vector reach into

    /// @param memory cache_lines(columns) of them
    /// @param columns of the part
    Scratch(CacheLine* memory, int columns) : memory_(memory->values), length_(length(columns)) {}

    [[nodiscard]] static constexpr std::size_t cache_lines(int columns) {
        return static_cast<std::size_t>(rows) * static_cast<std::size_t>(length(columns)) / CacheLine::numbers;
    }
    void clear() const { std::fill_n(memory_, rows * length_, Real(0)); }

    [[nodiscard]] std::array<Real*, 3> x(int slot) const { return three(9 * slot); }
    [[nodiscard]] std::array<Real*, 3> v(int slot) const { return three(9 * slot + 3); }
    [[nodiscard]] std::array<Real*, 3> wind(int slot) const { return three(9 * slot + 6); }

    /// Of the springs of one kind with first ends in a row, by the column of that end; three rows are kept, which hold
    /// what they held before until they are found.
    [[nodiscard]] std::array<Real*, 3> pulls(int kind, int row) const {
        return three(45 + 9 * kind + (row + 3) % 3 * 3);
    }

    /// Of each kind, by the column of the first end: 1 if there is a column for the second end, else 0.
    [[nodiscard]] Real* there(int kind) const { return row(99 + kind); }
    [[nodiscard]] Real* zeros() const { return row(105); }
    [[nodiscard]] std::array<Real*, 3> force() const { return three(106); }

private:
    static constexpr int rows = 109;
    static constexpr int length(int columns) {
        return (columns + 3 + CacheLine::numbers) / CacheLine::numbers * CacheLine::numbers + 2 * margin;
    }

    [[nodiscard]] Real* row(int number) const { return memory_ + number * length_; }
    [[nodiscard]] std::array<Real*, 3> three(int number) const {
        return {row(number), row(number + 1), row(number + 2)};
    }

    Real* memory_;
    int length_;
};

/// Makes a scratch ready for all sweeps over a part.
void lay_out(const Grid& grid, const Part& part, const Scratch& scratch);

/// Copies what other parts may overwrite while this one is swept: the rows next to it.
void copy_neighbours(const ForceInput& input, const Part& part, const Scratch& scratch);

/// Calls use(run) for each row of a part; what it reads of the part's particles is read before their run is used.
/// @pre the scratch is laid out, and has the neighbours as they are
void forces_on(const ForceInput& input, const Part& part, const Scratch& scratch,
               const std::function<void(const ForceRun&)>& use);

}  // namespace drape::kernels
