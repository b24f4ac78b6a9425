#pragma once

#include <filesystem>
#include <vector>

#include "experiment.h"

namespace drape {

/// Draws charts of a table as SVG and PNG beside it, each from a script that stays there for who wants to change it.
/// @return false if there is no gnuplot
/// @throws RunError if a script cannot be written, or gnuplot fails
bool draw_charts(const std::vector<Chart>& charts, const std::filesystem::path& table);

}  // namespace drape
