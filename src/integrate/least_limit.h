#pragma once

#include <functional>

#include "mode_search.h"

namespace drape {

/// The shortest of the steps up to which the vibrations of a cloth stay bounded.
struct LeastLimit {
    double stiffness = 0;  ///< k of the vibration that it is the limit of [1/s^2]
    double damping = 0;    ///< its d [1/s]
    double step = 0;       ///< [s]
    bool attained = true;  ///< a vibration with these k and d was found; else none has a shorter limit, that is all
    Points shape = {};     ///< of the vibration with the shortest limit that was found, as `Mode::shape`; may be empty
};

/// Finds the least value of a function of k and d over all vibrations of a cloth.
///
/// The pairs (k, d) of all vibrations, complex ones included, fill a convex set: the numerical range of K and D. Each
/// search for the largest a k + b d gives a line that this set lies behind, and a point at which it touches it. The
/// lines enclose the set from outside, the points span it from within. Where the least value outside is well below
/// that within, a search across the chord of the two neighbouring points cuts that corner off: both polygons close in
/// on each other quadratically.
/// @param search for the cloth at its state
/// @param least_damping no vibration has less [1/s]
/// @param longest the step of a vibration, by its k and d; it falls as both grow by s^2 and s
/// @cite johnson1978
LeastLimit least_limit(ModeSearch& search, double least_damping, const std::function<double(double, double)>& longest,
                       const std::function<bool(const Mode&)>& decides);

}  // namespace drape
