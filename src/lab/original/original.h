#pragma once

#include <filesystem>

#include "lab/experiment/row.h"

namespace drape {

/// How much of the original's scene is measured.
struct OriginalPlan {
    int first = 20;   ///< frames before, in which the cloth comes to lie on the ball
    int frames = 30;  ///< frames that are measured
    int passes = 5;   ///< of the recorded frames, to time build and search
};

/// The rows of one case: spheres and boxes in turn, without and with bounds in the picture.
/// @param program `drape-capture`; where it is not there, its cells stay empty
/// @throws RunError if a hierarchy disagrees with brute force, or the program fails
Rows original_rows(const OriginalPlan& plan, const std::filesystem::path& program);

}  // namespace drape
