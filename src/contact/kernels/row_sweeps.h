#pragma once

#include <span>

#include "drape/contact/contact_rows.h"

namespace drape::kernels {

/// One sweep of `solve_contact` over the rows of a cloth, to the bit.
/// @param offsets how many of each row count
/// @return the square of the largest change
Real sweep_rows(const ClothRows& cloth, std::span<CompactContact> rows, int offsets);

}  // namespace drape::kernels
