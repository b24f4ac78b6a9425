#pragma once

#include <ostream>

#include "drape/sim/simulation.h"

namespace drape {

/// The header `t,particle,x,y,z,vx,vy,vz`, with `cloth` after `t` where there are several.
void write_state_header(std::ostream& out, const Simulation& simulation);

/// One row a particle, 17 significant digits, C locale.
void write_state(std::ostream& out, const Simulation& simulation);

/// A comment with the units of `report_fields`, as in "# units: time [s], rms_speed [m/s]", without an end of line: it
/// comes before the header, whose names stay as they are. What it leaves out are counts and flags.
void write_report_units(std::ostream& out);

/// The names of `report_fields`, joined by commas, without an end of line.
void write_report_header(std::ostream& out);

/// The values of `report_fields`, joined by commas, without an end of line.
void write_report(std::ostream& out, const StepReport& report);

}  // namespace drape
