#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lab/hierarchy/hierarchy_run.h"

namespace drape {

/// One way in which the original's scene is run.
struct OriginalWay {
    std::string volume;         ///< sphere or aabb
    bool bounds_drawn = false;  ///< a level of the hierarchy is in the picture, as in the original
};

/// How much of it is measured.
struct OriginalPlan {
    int first = 20;   ///< frames before, in which the cloth comes to lie on the ball
    int frames = 30;  ///< frames that are measured
    int passes = 5;   ///< of the recorded frames, to time build and search
};

/// What is set in the original's scene: a ball that the cloth lies on, a hierarchy rebuilt in every step, nothing
/// saved where nothing moves.
std::vector<std::string> original_assignments(const OriginalWay& way);

/// CPU times of a hierarchy on the scene's cloth [s].
struct OriginalSearch {
    double build = 0, search = 0, exact = 0;  ///< one each, medians over frames
    double candidates = 0;                    ///< cells that a search hands to the exact test, mean over frames
};

/// What simulating takes, without drawing.
struct OriginalTimes {
    Quartiles execution;    ///< all steps of a frame [s]
    OriginalSearch scene;   ///< with the leaves that the scene has
    OriginalSearch single;  ///< with a tree that goes down to single cells
};

/// @throws RunError if a hierarchy disagrees with brute force
OriginalTimes time_original(const OriginalWay& way, const OriginalPlan& plan);

/// What `drape-capture` says of the pictures: medians over frames.
struct OriginalPictures {
    double rate = 0;      ///< frames per second
    double gl_calls = 0;  ///< a frame
    double cpu = 0;       ///< processor time over wall time; more than 1 where several threads draw
    double vertices = 0;  ///< a frame
};

/// @param program to draw with
/// @return nothing if there is no such program
/// @throws RunError if it fails
std::optional<OriginalPictures> draw_original(const OriginalWay& way, const OriginalPlan& plan,
                                              const std::filesystem::path& program);

}  // namespace drape
