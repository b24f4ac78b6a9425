#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>

#include "drape/scene/settings.h"
#include "drape/scene/start_state.h"
#include "drape/sim/cloth.h"
#include "drape/sim/step_report.h"

namespace drape {

/// Looks at what the integrators have made of a substep, enters it in each cloth's energy, and marks in the report what
/// is in doubt.
/// @param h substep that was made [s]
/// @param planned substeps of a step without contact
/// @return why the run must end, one line: a cloth has diverged or a step could not be made; under
///         `on_unstable = stop` also a doubt. Empty while it goes on
std::string check_substep(std::span<Cloth> cloths, std::span<const Ball> balls, const Settings& settings, Real h,
                          int planned, StepReport& report);

/// Reports the largest excess over the stretch limits that shortening and contact have left at the end of a step of
/// length dt [s].
/// @par Cost one pass over two springs a particle; nothing without a limit
void measure_stretch(std::span<const Cloth> cloths, double dt, StepReport& report);

/// Marks in the report that in a substep at a time, of length h [s], something may have passed through the cloth
/// unseen.
void mark_crossing(const Crossing& crossing, double time, Real h, StepReport& report);

/// Clauses with semicolons between, but for those that are empty.
std::string joined(std::initializer_list<std::string> clauses);

/// That this was so, with the speeds as it began; empty if never.
std::string crossing_warning(const TunnellingRisk& danger);

/// That cloth moves too far within a substep for contact between cloths.
std::string search_error(const StepReport& report);

/// How deep the deepest particle that is not pinned is in a ball, a solid or the ground [m]; 0 if none is deeper than
/// the cloth is thick.
/// @par Cost O(particles * (balls + solids))
Real deepest_particle(std::span<const Cloth> cloths, std::span<const Ball> balls, std::span<const Solid> solids,
                      const Ground& ground, Real thickness);

/// That cloth crossed cloth at the start, or touched it at distance 0, so many times, or was so deep in something;
/// empty if nothing of this.
std::string start_warning(std::int64_t crossings, std::int64_t coincident, Real depth);

/// That balls which keys or forces move start where the scene has them, for the state in which the cloths start has
/// none; empty if not so.
std::string ball_start_warning(const Settings& settings, const std::optional<StartState>& start);

/// Why the run so far is not to be trusted, one line; empty if nothing.
std::string reliability_warning(const StepReport& report, std::span<const Cloth> cloths, std::span<const Ball> balls);

}  // namespace drape
