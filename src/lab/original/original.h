#pragma once

#include <array>
#include <filesystem>
#include <limits>

#include "lab/experiment/experiment.h"

namespace drape {

/// One way in which the original's scene is run.
struct OriginalWay {
    std::string volume;         ///< sphere or aabb
    bool bounds_drawn = false;  ///< a level of the hierarchy is in the picture, as in the original
};

/// The ways in which the scene is run, in the order of table and chart.
inline const std::array<OriginalWay, 4> original_ways{
    {{"sphere", false}, {"aabb", false}, {"sphere", true}, {"aabb", true}}};

/// How much of it is measured.
struct OriginalPlan {
    int first = 20;   ///< frames before, in which the cloth comes to lie on the ball
    int frames = 30;  ///< frames that are measured
    int passes = 5;   ///< of the recorded frames, to time build and search
};

/// A hierarchy on the scene's cloth.
struct OriginalSearch {
    double build = 0, search = 0, exact = 0;  ///< CPU times of one each, medians over frames [s]
    double candidates = 0;                    ///< cells that a search hands to the exact test, mean over frames
};

/// One way in which the scene is run, once. What only a program that draws can tell is nan where there is none.
struct OriginalRow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string volume;
    double drawn = 0;                                                ///< 1 if bounds are in the picture
    double execution = 0, execution_lower = 0, execution_upper = 0;  ///< CPU time of all steps of a frame [s]
    double rate = none;                                              ///< frames per second, a median as all of these
    double gl_calls = none, vertices = none;                         ///< a frame
    double cpu = none;  ///< processor time over wall time; more than 1 where several threads draw
    double build = 0, search = 0, exact = 0, candidates = 0;  ///< see OriginalSearch; with the scene's leaves
    double single_build = 0, single_search = 0, single_exact = 0, single_candidates = 0;  ///< down to single cells
};
using OriginalRows = std::vector<OriginalRow>;

/// Measures what simulating takes, without drawing.
/// @throws RunError if a hierarchy disagrees with brute force
OriginalRow time_original(const OriginalWay& way, const OriginalPlan& plan);

/// Adds what `drape-capture` says of the pictures.
/// @param program to draw with
/// @return false if there is no such program
/// @throws RunError if it fails
bool draw_original(const OriginalWay& way, const OriginalPlan& plan, const std::filesystem::path& program,
                   OriginalRow& row);

/// The rows of one case: spheres and boxes in turn, without and with bounds in the picture.
/// @param draws receives whether there was a program to draw with
OriginalRows original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws);

/// The five tests side by side, and build and search apart.
std::vector<Chart> original_charts(const OriginalRows& rows);

/// The five tests, and whether the dissertation's conclusion holds.
std::string original_summary(const OriginalRows& rows);

/// Whether both halves of the dissertation's conclusion hold: spheres are more expensive to build, and faster to
/// search.
/// @param sphere,aabb medians
std::string original_conclusion(const OriginalSearch& sphere, const OriginalSearch& aabb);

}  // namespace drape
