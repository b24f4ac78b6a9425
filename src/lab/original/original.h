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

/// Adds what `drape-capture` says of the pictures.
/// @param program to draw with
/// @return false if there is no such program
/// @throws RunError if it fails
bool draw_original(const OriginalWay& way, const OriginalPlan& plan, const std::filesystem::path& program, Row& row);

/// The rows of one case: spheres and boxes in turn, without and with bounds in the picture.
/// @param draws receives whether there was a program to draw with
/// @throws RunError if a hierarchy disagrees with brute force
Rows original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws);

}  // namespace drape
