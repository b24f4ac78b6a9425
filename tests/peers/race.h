#pragma once

#include <string>
#include <vector>

#include "method.h"
#include "motion.h"

namespace drape::peers {

/// Medians over the frames that a method was timed on.
struct Result {
    std::string method;
    int frames = 0;
    int ties = 0;  ///< triangles within rounding of touching, on which method and brute force differ, of all frames
    double update = 0;  ///< [s]
    double query = 0;   ///< down to the touched triangles [s]
    double total = 0;   ///< of both in one frame [s]
    bool ours = false;  ///< a tree of Drape's
};

/// Times all methods on one motion. They take turns; in its turn a method runs through the motion, again and again for
/// at least 10 ms and for no longer than 1 s, going on where it stopped. Every frame is checked against brute force.
/// @throws RunError if a method finds another set
std::vector<Result> race(const Motion& motion, int turns);

}  // namespace drape::peers
