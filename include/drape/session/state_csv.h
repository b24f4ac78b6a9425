#pragma once

#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "drape/sim/simulation.h"

namespace drape {

/// The header `t,particle,x,y,z,vx,vy,vz`, with `cloth` after `t` where there are several. Where there are balls, a
/// comment with `ball_columns` follows.
void write_state_header(std::ostream& out, const Simulation& simulation);

/// One row a particle, then a comment a ball; 17 significant digits, C locale. Solids and pins that move follow from
/// the time.
void write_state(std::ostream& out, const Simulation& simulation);

/// A column of a table of figures, a row a time or a frame.
struct StatsColumn {
    std::string name;
    std::string unit;  ///< "s", "m/s"; empty for counts and flags
    std::function<std::string(const FrameView& view)> cell;
};

/// Those of `report_fields`.
void add_report_columns(std::vector<StatsColumn>& columns);

/// The `ball_fields` of so many balls: "ball0_x". A ball that is no longer there has empty cells.
void add_ball_columns(std::vector<StatsColumn>& columns, std::size_t balls);

/// A comment with the units, as in "# units: time [s], rms_speed [m/s]", then the names, which stay as they are.
void write_stats_head(std::ostream& out, std::span<const StatsColumn> columns);

void write_stats_row(std::ostream& out, std::span<const StatsColumn> columns, const FrameView& view);

}  // namespace drape
