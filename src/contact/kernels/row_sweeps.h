#pragma once

#include <span>

#include "contact/solve/problem.h"

namespace drape::kernels {

/// One sweep of `solve` over compact rows, with the bits of the plain code.
/// @param motion of the particles
/// @return the square of the largest change
Real sweep_rows(std::span<Real4> motion, std::span<CompactRow> rows);

}  // namespace drape::kernels
