#pragma once

#include <ostream>

#include "drape/sim/simulation.h"

namespace drape {

/// The header `t,particle,x,y,z,vx,vy,vz`, with `cloth` after `t` where there are several.
void write_state_header(std::ostream& out, const Simulation& simulation);

/// One row a particle, 17 significant digits, C locale.
void write_state(std::ostream& out, const Simulation& simulation);

/// The names of `report_fields`, joined by commas, without an end of line.
void write_report_header(std::ostream& out);

/// The values of `report_fields`, joined by commas, without an end of line.
void write_report(std::ostream& out, const StepReport& report);

}  // namespace drape
