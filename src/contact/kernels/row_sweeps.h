#pragma once

#include <span>

#include "drape/contact/contact_rows.h"

namespace drape::kernels {

/// One sweep of `solve_contact` over compact contacts, to the bit.
/// @param motion of the particles
/// @param offsets how many of each row count
/// @return the square of the largest change
Real sweep_rows(std::span<Real4> motion, std::span<CompactContact> rows, int offsets);

}  // namespace drape::kernels
