#include "drape/sim/step_report.h"

#include <array>

namespace drape {
namespace {

constexpr double micro = 1e6;  // seconds are shown as microseconds

using Report = StepReport;
using Search = TraversalStats;
using Balance = EnergyBalance;

/// A field, reached by one member after another.
template <auto... members>
double field(const Report& r) {
    return static_cast<double>((r.*....*members));
}

template <double StageTimes::*stage>
double time_of(const Report& r) {
    return micro * r.times.*stage;
}

double total_time(const Report& r) { return micro * r.times.total(); }

const auto fields = std::to_array<ReportField>({
    {"step", "", field<&Report::step>, "step", ReportGroup::Time, 3},
    {"time", "s", field<&Report::time>, "time", ReportGroup::Time, 3},
    {"substeps", "", field<&Report::substeps>},
    {"step_limit_ratio", "1", field<&Report::step_limit_ratio>},
    {"unconverged", "", field<&Report::unconverged>, "unsolved", ReportGroup::Doubt, 4, field<&Report::step>},
    {"residual", "1", field<&Report::solve, &SolveReport::residual>},
    {"worst_residual", "1", field<&Report::worst_residual>, "residual", ReportGroup::Doubt, 4},
    {"energy_excess", "J", field<&Report::energy_excess>, "excess", ReportGroup::Doubt, 4},
    {"energy_gain_step", "", field<&Report::energy_gain_step>},
    {"step_time", "us", time_of<&StageTimes::step>, "integrate", ReportGroup::Stages, 1, total_time},
    {"build_time", "us", time_of<&StageTimes::build>, "build", ReportGroup::Stages, 1, total_time},
    {"traverse_time", "us", time_of<&StageTimes::traverse>, "traverse", ReportGroup::Stages, 1, total_time},
    {"narrow_time", "us", time_of<&StageTimes::narrow>, "narrow phase", ReportGroup::Stages, 1, total_time},
    {"respond_time", "us", time_of<&StageTimes::respond>, "response", ReportGroup::Stages, 1, total_time},
    {"total_time", "us", total_time},
    {"force_evaluations", "", field<&Report::solve, &SolveReport::force_evaluations>},
    {"iterations", "", field<&Report::solve, &SolveReport::iterations>},
    {"nodes", "", field<&Report::traversal, &Search::nodes>},
    {"visited", "", field<&Report::traversal, &Search::visited>},
    {"volume_tests", "", field<&Report::traversal, &Search::volume_tests>, "volume tests", ReportGroup::Hierarchy, 3,
     field<&Report::traversal, &Search::nodes>},
    {"pruned", "", field<&Report::traversal, &Search::pruned>},
    {"leaves", "", field<&Report::traversal, &Search::leaves>},
    {"candidates", "", field<&Report::traversal, &Search::candidates>, "candidates", ReportGroup::Hierarchy, 2},
    {"false_candidates", "", field<&Report::false_candidates>, "false positives", ReportGroup::Hierarchy, 1,
     field<&Report::traversal, &Search::candidates>},
    {"contacts", "", field<&Report::contacts>, "contacts", ReportGroup::Hierarchy, 3},
    {"ground_visited", "", field<&Report::ground, &Search::visited>},
    {"ground_pruned", "", field<&Report::ground, &Search::pruned>},
    {"solid_visited", "", field<&Report::solids, &Search::visited>},
    {"solid_pruned", "", field<&Report::solids, &Search::pruned>},
    {"penetration", "m", field<&Report::penetration>, "penetration", ReportGroup::Hierarchy, 1},
    {"contact_residual", "m", field<&Report::contact_residual>},
    {"contact_sweeps", "", field<&Report::contact_sweeps>},
    {"stopped", "", field<&Report::traversal, &Search::stopped>, "stopped at", ReportGroup::Limit, 2},
    {"false_contacts", "", field<&Report::false_contacts>, "false nodes", ReportGroup::Limit, 2,
     field<&Report::traversal, &Search::stopped>},
    {"missed_penetration", "m", field<&Report::missed_penetration>, "missed", ReportGroup::Limit, 2},
    {"pairs_time", "us", time_of<&StageTimes::pairs>, "cloth on cloth", ReportGroup::Pairs, 1, total_time},
    {"pair_tests", "", field<&Report::between_cloths, &Search::volume_tests>},
    {"listed_pairs", "", field<&Report::listed_pairs>, "listed pairs", ReportGroup::Pairs, 2},
    {"pairs", "", field<&Report::pairs>, "pairs", ReportGroup::Pairs, 2},
    {"failsafe_particles", "", field<&Report::failsafe_particles>, "fail-safe", ReportGroup::Pairs, 2},
    {"rms_speed", "m/s", field<&Report::rms_speed>},
    {"stretch", "1", field<&Report::stretch>, "stretch", ReportGroup::Energy, 3},
    {"stretch_excess", "1", field<&Report::stretch_excess>},
    {"kinetic", "J", field<&Report::energy, &Energy::kinetic>, "kinetic", ReportGroup::Energy, 2},
    {"gravity", "J", field<&Report::energy, &Energy::gravity>, "gravity", ReportGroup::Energy, 1},
    {"spring", "J", field<&Report::energy, &Energy::spring>, "spring", ReportGroup::Energy, 1},
    {"energy", "J", [](const Report& r) { return r.energy.total(); }, "total", ReportGroup::Energy, 2},
    {"damping_loss", "J", field<&Report::balance, &Balance::damping>, "to damping", ReportGroup::Balance, 3},
    {"drag_loss", "J", field<&Report::balance, &Balance::drag>, "to drag", ReportGroup::Balance, 3},
    {"contact_loss", "J", field<&Report::balance, &Balance::contact>, "to contact", ReportGroup::Balance, 3},
    {"failsafe_loss", "J", field<&Report::balance, &Balance::failsafe>, "to fail-safe", ReportGroup::Balance, 3},
    {"integrator_loss", "J", field<&Report::balance, &Balance::integrator>, "integrator loss", ReportGroup::Balance, 3},
    {"wind_work", "J", field<&Report::balance, &Balance::wind>, "from wind", ReportGroup::Balance, 3},
    {"hand_work", "J", field<&Report::balance, &Balance::hand>, "from hand", ReportGroup::Balance, 3},
    {"pin_work", "J", field<&Report::balance, &Balance::pins>, "from pins", ReportGroup::Balance, 3},
    {"ball_work", "J", field<&Report::balance, &Balance::ball>, "from ball", ReportGroup::Balance, 3},
    {"asleep", "", field<&Report::asleep>},
    {"diverged", "", [](const Report& r) { return r.status == Status::Diverged ? 1.0 : 0.0; }},
});

constexpr auto fields_of_a_ball = std::to_array<BallField>({
    {"x", "m", [](const Ball& b) { return static_cast<double>(b.centre.x()); }},
    {"y", "m", [](const Ball& b) { return static_cast<double>(b.centre.y()); }},
    {"z", "m", [](const Ball& b) { return static_cast<double>(b.centre.z()); }},
    {"vx", "m/s", [](const Ball& b) { return static_cast<double>(b.velocity.x()); }},
    {"vy", "m/s", [](const Ball& b) { return static_cast<double>(b.velocity.y()); }},
    {"vz", "m/s", [](const Ball& b) { return static_cast<double>(b.velocity.z()); }},
    {"spin_x", "rad/s", [](const Ball& b) { return static_cast<double>(b.spin.x()); }},
    {"spin_y", "rad/s", [](const Ball& b) { return static_cast<double>(b.spin.y()); }},
    {"spin_z", "rad/s", [](const Ball& b) { return static_cast<double>(b.spin.z()); }},
});

}  // namespace

std::span<const ReportField> report_fields() { return fields; }

std::span<const BallField> ball_fields() { return fields_of_a_ball; }

}  // namespace drape
