#pragma once

#include "drape/base/enum_names.h"

namespace drape {

/// The two ways through each computation. `Plain` is scalar code, a few lines beside its equation, to read and to step
/// through; `Vector` does the same arithmetic with the widest vectors of the processor, to rounding the same.
enum class Kernels { Vector, Plain };

}  // namespace drape
