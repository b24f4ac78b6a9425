#pragma once

#include <optional>
#include <span>

namespace drape {

/// The frame from which on, and to the last, one way has cost more in all than another.
/// @param costs of each frame of the way that is cheap at first
/// @param others of the other way, as many
/// @return counted from 0; nothing if it has not cost more when the last frame ends
std::optional<std::size_t> break_even_frame(std::span<const double> costs, std::span<const double> others);

}  // namespace drape
