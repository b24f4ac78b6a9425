#pragma once

#include <array>
#include <cstddef>

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape::kernels {

/// Cells of a grid, and the points of their triangles that are closest to the centre of a ball: one array a number.
struct CellBatch {
    static constexpr std::size_t size = 32;
    using Numbers = std::array<Real, size>;
    using Vectors = std::array<Numbers, 3>;

    /// As in `ClosestPoint`.
    struct Closest {
        alignas(64) Vectors point{};        ///< by coordinate
        alignas(64) Vectors barycentric{};  ///< by corner of the triangle
        alignas(64) Numbers square{};       ///< of the distance
    };

    /// Which corners of a cell its triangles have.
    static constexpr std::array<std::array<std::size_t, 3>, 2> corners_of{{{0, 2, 1}, {1, 2, 3}}};

    std::size_t count = 0;
    std::array<int, size> cell{};
    std::array<int, size> corner_a{};              ///< a particle
    alignas(64) std::array<Vectors, 4> corners{};  ///< by corner a, b, c, d and coordinate
    std::array<Closest, 2> closest{};              ///< of triangle 2 cell, and of the next

    [[nodiscard]] bool full() const { return count == size; }

    /// @param a the particle at corner a
    void add(const Grid& grid, const Points& x, int number, int a) {
        cell[count] = number;
        corner_a[count] = a;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Real* const from = x.data() + static_cast<std::ptrdiff_t>(axis) * x.rows() + a;
            corners[0][axis][count] = from[0];
            corners[1][axis][count] = from[1];
            corners[2][axis][count] = from[grid.nx];
            corners[3][axis][count] = from[grid.nx + 1];
        }
        ++count;
    }
};

/// Finds the closest points of a batch, with the bits of `closest_point_on_triangle`.
/// @par Cost O(count), vectorised, but for needles
void find_closest_points(CellBatch& batch, const Vec3& centre);

}  // namespace drape::kernels
