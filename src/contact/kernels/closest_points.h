#pragma once

#include <array>
#include <span>

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape::kernels {

/// Triangles of a grid, and the point of each that is closest to the centre of a ball: one array a number.
struct TriangleBatch {
    static constexpr std::size_t size = 64;
    using Numbers = std::array<Real, size>;
    using Vectors = std::array<Numbers, 3>;

    std::size_t count = 0;
    std::array<int, size> triangle{};
    alignas(64) std::array<Vectors, 3> corners{};  ///< by corner and coordinate
    alignas(64) Vectors barycentric{};             ///< by corner
    alignas(64) Vectors point{};                   ///< by coordinate
    alignas(64) Numbers square{};                  ///< of the distance

    [[nodiscard]] bool full() const { return count == size; }

    void add(const Grid& grid, const Points& x, int number) {
        triangle[count] = number;
        const std::array<int, 3> particles = grid.triangle_corners(number);
        for (int axis = 0; axis < 3; ++axis) {
            const Real* const from = x.col(axis).data();
            for (std::size_t k = 0; k < 3; ++k) corners[k][static_cast<std::size_t>(axis)][count] = from[particles[k]];
        }
        ++count;
    }
};

/// Finds the closest points of a batch, with the bits of `closest_point_on_triangle`.
/// @par Cost O(count), vectorised, but for needles
void find_closest_points(TriangleBatch& batch, const Vec3& centre);

}  // namespace drape::kernels
