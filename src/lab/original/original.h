#pragma once

#include <array>
#include <filesystem>

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
struct OriginalRow : OriginalWay {
    Quartiles execution;            ///< CPU time of all steps of a frame [s]
    OriginalSearch leaves, single;  ///< with the scene's leaves, and down to single cells
    double rate = no_number;        ///< frames per second, a median as all of these
    double gl_calls = no_number;    ///< a frame
    double cpu = no_number;         ///< processor time over wall time; more than 1 where several threads draw
    double vertices = no_number;    ///< a frame
};
using OriginalRows = std::vector<OriginalRow>;

/// Adds what `drape-capture` says of the pictures.
/// @param program to draw with
/// @return false if there is no such program
/// @throws RunError if it fails
bool draw_original(const OriginalWay& way, const OriginalPlan& plan, const std::filesystem::path& program,
                   OriginalRow& row);

/// The rows of one case: spheres and boxes in turn, without and with bounds in the picture.
/// @param draws receives whether there was a program to draw with
/// @throws RunError if a hierarchy disagrees with brute force
OriginalRows original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws);

/// The five tests side by side, and build and search apart.
std::vector<Chart> original_charts(const OriginalRows& rows);

}  // namespace drape
