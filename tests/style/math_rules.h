#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "include_rules.h"

namespace drape::style {

/// Finds the calls, in the sources under `root` of the layers that decide a state, a report or a table, of functions
/// whose bits the standards leave open: those of the C library but for the exact ones (square root, rounding,
/// remainder, scaling), the distributions of the standard library, and what of Eigen rests on either. Files whose name
/// ends in `_charts.cpp` draw.
std::vector<Offence> check_math(const std::filesystem::path& root);

/// Finds the same among the names that compiled code asks for, whatever header they come from.
/// @param listing what `nm -u` prints of a library
std::vector<Offence> check_symbols(const std::string& listing);

}  // namespace drape::style
