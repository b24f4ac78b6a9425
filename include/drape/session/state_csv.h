#pragma once

#include <ostream>
#include <span>

#include "drape/sim/simulation.h"

namespace drape {

/// The header `t,particle,x,y,z,vx,vy,vz`, with `cloth` after `t` where there are several. Where there are balls, a
/// comment with `ball_columns` follows.
void write_state_header(std::ostream& out, const Simulation& simulation);

/// One row a particle, then a comment a ball; 17 significant digits, C locale. Solids and pins that move follow from
/// the time.
void write_state(std::ostream& out, const Simulation& simulation);

/// A comment with the units of `report_fields`, as in "# units: time [s], rms_speed [m/s]", without an end of line: it
/// comes before the header, whose names stay as they are. What it leaves out are counts and flags.
void write_report_units(std::ostream& out);

/// The names of `report_fields`, joined by commas, without an end of line.
void write_report_header(std::ostream& out);

/// The values of `report_fields`, joined by commas, without an end of line.
void write_report(std::ostream& out, const StepReport& report);

/// The `ball_fields` of so many balls with their units, after those of the report: ", ball0_x [m]".
void write_ball_units(std::ostream& out, std::size_t balls);

/// Likewise their names: ",ball0_x".
void write_ball_header(std::ostream& out, std::size_t balls);

/// Likewise their values; nothing between the commas for a ball that is no longer there.
/// @param columns balls that have some
void write_balls(std::ostream& out, std::span<const Ball> balls, std::size_t columns);

}  // namespace drape
