#pragma once

#include <span>

#include "contact/contact_batches.h"

namespace drape::kernels {

/// One sweep of `solve_contact` over batches of contacts, to the bit.
/// @param motion of particles, where the slots of the batches are counted from
/// @return the square of the largest change
Real sweep_batches(std::span<ContactBatch> batches, Real* motion);

}  // namespace drape::kernels
