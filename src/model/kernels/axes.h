#pragma once

#include <array>

#include "drape/base/real.h"

namespace drape::kernels {

/// The coordinate arrays of n x 3 numbers.
inline std::array<const Real*, 3> axes(const Points& p) { return {p.col(0).data(), p.col(1).data(), p.col(2).data()}; }
inline std::array<Real*, 3> axes(Points& p) { return {p.col(0).data(), p.col(1).data(), p.col(2).data()}; }

}  // namespace drape::kernels
