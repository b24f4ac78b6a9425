#pragma once

#include "drape/base/exact_math.h"
#include "drape/model/cloth_model.h"
#include "drape/scene/settings.h"

namespace drape {

/// The air with gusts on the mean wind, of their amplitude times a number in [-1, 1].
inline Air air_in_gusts(const WindSettings& wind, double gusts) {
    constexpr Real air_density = Real(1.225);  // kg/m^3, at 15 degrees Celsius and sea level (ISO 2533)
    if (!wind.on) return {};
    return {wind.velocity * (1 + wind.gust * static_cast<Real>(gusts)), air_density};
}

/// The air at a time: the mean wind with two gusts of incommensurate frequency on it. It depends on time alone.
inline Air air_at(const WindSettings& wind, double time) {
    return air_in_gusts(wind, (sine(2.1 * time) + sine(5.3 * time + 1.3)) / 2);
}

/// The fastest that it can get.
inline Air strongest_air(const WindSettings& wind) { return air_in_gusts(wind, 1); }

}  // namespace drape
