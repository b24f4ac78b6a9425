#pragma once

#include <array>

#include "drape/base/real.h"

namespace drape {

/// The thirteen lines through a cube's centre and the middle of a face (0 to 2), a corner (3 to 6) or the middle of an
/// edge (7 to 12): the directions of k-DOPs and of EPOS spheres. Not of length 1, so that a projection is a sum.
/// @cite klosowski1998
inline constexpr std::array<std::array<int, 3>, 13> dop_axes{{{1, 0, 0},
                                                              {0, 1, 0},
                                                              {0, 0, 1},
                                                              {1, 1, 1},
                                                              {1, 1, -1},
                                                              {1, -1, 1},
                                                              {1, -1, -1},
                                                              {1, 1, 0},
                                                              {1, -1, 0},
                                                              {1, 0, 1},
                                                              {1, 0, -1},
                                                              {0, 1, 1},
                                                              {0, 1, -1}}};

/// The directions of a k-DOP by their numbers in `dop_axes`, K / 2 of them: those of the faces come first, then
/// corners in 14 and 26, edges in 18 and 26.
template <int K>
inline constexpr std::array<int, K / 2> dop_numbers{};
template <>
inline constexpr std::array<int, 3> dop_numbers<6>{0, 1, 2};
template <>
inline constexpr std::array<int, 7> dop_numbers<14>{0, 1, 2, 3, 4, 5, 6};
template <>
inline constexpr std::array<int, 9> dop_numbers<18>{0, 1, 2, 7, 8, 9, 10, 11, 12};
template <>
inline constexpr std::array<int, 13> dop_numbers<26>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

/// The length of a direction.
constexpr Real dop_length(int number) {
    return number < 3 ? Real(1) : number < 7 ? Real(1.7320508075688774) : Real(1.4142135623730951);
}

/// A direction's product with a point, by sums alone.
inline Real dop_projection(int number, const Vec3& p) {
    const std::array<int, 3>& axis = dop_axes[static_cast<std::size_t>(number)];
    Real sum = 0;
    for (int k = 0; k < 3; ++k) {
        if (axis[static_cast<std::size_t>(k)] > 0) sum += p[k];
        if (axis[static_cast<std::size_t>(k)] < 0) sum -= p[k];
    }
    return sum;
}

}  // namespace drape
