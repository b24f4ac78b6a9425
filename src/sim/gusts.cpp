#include "gusts.h"

#include "drape/base/exact_math.h"

namespace drape {
namespace {

/// Density of air at 15 degrees Celsius and sea level (ISO 2533) [kg/m^3].
constexpr Real air_density = Real(1.225);

Air air_in_gusts(const WindSettings& wind, double gusts) {
    if (!wind.on) return {};
    return {wind.velocity * (1 + wind.gust * static_cast<Real>(gusts)), air_density};
}

}  // namespace

Air air_at(const WindSettings& wind, double time) {
    return air_in_gusts(wind, (sine(2.1 * time) + sine(5.3 * time + 1.3)) / 2);
}

Air strongest_air(const WindSettings& wind) { return air_in_gusts(wind, 1); }

}  // namespace drape
