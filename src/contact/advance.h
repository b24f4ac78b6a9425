#pragma once

#include <optional>

#include "drape/base/real.h"
#include "tuning.h"

namespace drape {

/// How far two things are apart at a time, and until when they certainly are.
struct Advance {
    Real distance;  ///< [m]
    Real next;      ///< until this time they stay apart, in parts of the step
};

/// The first time at which two things that move within a step are as near as is asked, by conservative advancement:
/// from one time to the next until which they cannot meet @cite li2021. No root has to be found, and none can be lost.
/// @param measure measure(t) is the `Advance` at a time t; its next is to lead a little nearer than `near`, or the
/// advances would never arrive. So what comes hardly nearer than that may be missed
/// @param near [m]
/// @return in parts of the step, from 0 to 1; none if they do not come as near. After `max_advances`, the next time,
/// which was not measured
/// @par Cost that of `measure`, a few times; at most `max_advances` times
template <class Measure>
std::optional<Real> first_time(Measure measure, Real near) {
    Real t = 0;
    for (int k = 0; k < max_advances; ++k) {
        const Advance now = measure(t);
        if (now.distance <= near || now.next <= t) return t;
        if (!(now.next <= 1)) return std::nullopt;
        t = now.next;
    }
    return t;
}

}  // namespace drape
