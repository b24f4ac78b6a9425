#pragma once

#include <array>

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

}  // namespace drape
