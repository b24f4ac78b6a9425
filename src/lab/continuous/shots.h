#pragma once

#include <vector>

#include "drape/base/real.h"
#include "lab/measure/statistics.h"

namespace drape {

/// What balls are shot at.
enum class Target {
    Point,  ///< a cloth a ten thousandth as wide as the ball
    Sheet   ///< a wide flat one, at right angles to the way
};

/// How many shots pass unseen, of those whose way passes the target nearer than the ball's radius.
struct ShotCount {
    double shots = 0;
    double discrete = 0;    ///< missed by discrete detection
    double continuous = 0;  ///< missed by all that may have met between them
};

/// Shoots a ball through a cloth at rest, in steps of q of its diameters: q = v dt / (2 R). A point is passed at a
/// distance that is even over the ball's disc, in a direction that is even over all; the first step is even within one.
/// @throws RunError if a tree does not find the contacts that all cells have
ShotCount shoot(Target target, double q, int shots);

/// The part that discrete detection misses. A chord at the distance b from a ball's centre is c = 2 sqrt(R^2 - b^2)
/// long, and is stepped over with the probability 1 - c / (2 R q), if that is positive. With b even over the disc its
/// mean is q^2 / 3 for q <= 1 and 1 - 2 / (3 q) above. A sheet's chord is always 2 R long: 0, and 1 - 1 / q above.
double predicted_misses(Target target, double q);

/// CPU times of one way to detect, over steps in which a ball of 5 cm at 10 m/s meets a sheet that moves [s].
struct DetectionTimes {
    Quartiles build, search;  ///< the search is query and exact test
};

struct BothDetections {
    DetectionTimes discrete, continuous;
};

/// Measured in turn.
/// @param side particles along each side of the sheet
BothDetections time_detections(int side, int steps);

}  // namespace drape
