#pragma once

#include "drape/contact/flat_blocks.h"

namespace drape::kernels {

/// As the function of the same name with `Kernels::Vector`, and with the bits of the plain one.
void find_block_room(const BlockRoom& of, std::span<Real> room);

}  // namespace drape::kernels
