#pragma once

#include <array>
#include <filesystem>

#include "lab/experiment/experiment.h"
#include "original_frames.h"

namespace drape {

/// One way in which the scene is run, once. What only a program that draws can tell is nan where there is none.
struct OriginalRow {
    std::string volume;
    double drawn = 0;                                                ///< 1 if bounds are in the picture
    double execution = 0, execution_lower = 0, execution_upper = 0;  ///< all steps of a frame [s]
    double rate = 0, gl_calls = 0, cpu = 0, vertices = 0;            ///< see OriginalPictures
    double build = 0, search = 0, exact = 0, candidates = 0;         ///< see OriginalSearch
    double single_build = 0, single_search = 0, single_exact = 0, single_candidates = 0;  ///< down to single cells
};
using OriginalRows = std::vector<OriginalRow>;

/// The five tests side by side, and build and search apart.
std::vector<Chart> original_charts(const OriginalRows& rows);

/// The five tests, and whether the dissertation's conclusion holds.
std::string original_summary(const OriginalRows& rows);

/// The rows of one case: spheres and boxes in turn, without and with bounds in the picture.
/// @param program that draws; where there is none, what it would have told is nan
/// @param draws receives whether there was one
OriginalRows original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws);

/// Whether both halves of the dissertation's conclusion hold: spheres are more expensive to build, and faster to
/// search.
/// @param sphere,aabb medians
std::string original_conclusion(const OriginalSearch& sphere, const OriginalSearch& aabb);

/// The ways in which the scene is run, in the order of table and chart.
inline const std::array<OriginalWay, 4> original_ways{
    {{"sphere", false}, {"aabb", false}, {"sphere", true}, {"aabb", true}}};

}  // namespace drape
