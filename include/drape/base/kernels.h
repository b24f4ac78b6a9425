#pragma once

#include <array>
#include <string>

namespace drape {

/// The two ways through each computation. `Plain` is scalar code, a few lines beside its equation, to read and to step
/// through; `Vector` does the same arithmetic with the widest vectors of the processor, to rounding the same.
enum class Kernels { Vector, Plain };

/// In the order of the enumeration.
inline const std::array<std::string, 2> kernels_names{"vector", "plain"};

}  // namespace drape
