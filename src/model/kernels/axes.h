#pragma once

#include <array>

#include "drape/base/real.h"

namespace drape::kernels {

/// The coordinate arrays of n x 3 numbers.
inline std::array<const Real*, 3> axes(const Points& p) { return {p.col(0).data(), p.col(1).data(), p.col(2).data()}; }
inline std::array<Real*, 3> axes(Points& p) { return {p.col(0).data(), p.col(1).data(), p.col(2).data()}; }

/// Springs, cells and particles are evaluated in runs of this many, so that what is found of them fits on the stack.
constexpr int run_length = 128;

}  // namespace drape::kernels
