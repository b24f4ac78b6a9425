#include "drape/sim/step_report.h"

#include <array>

namespace drape {
namespace {

constexpr double micro = 1e6;  // seconds are shown as microseconds

double total_time(const StepReport& r) { return micro * r.times.total(); }
double steps(const StepReport& r) { return static_cast<double>(r.step); }
double nodes(const StepReport& r) { return static_cast<double>(r.traversal.nodes); }
double candidates(const StepReport& r) { return static_cast<double>(r.traversal.candidates); }
double stopped(const StepReport& r) { return static_cast<double>(r.traversal.stopped); }

const auto fields = std::to_array<ReportField>({
    {"step", "", steps, "step", ReportGroup::Time, 3},
    {"time", "s", [](const StepReport& r) { return r.time; }, "time", ReportGroup::Time, 3},
    {"substeps", "", [](const StepReport& r) { return static_cast<double>(r.substeps); }},
    {"step_limit_ratio", "1", [](const StepReport& r) { return r.step_limit_ratio; }},
    {"unconverged", "", [](const StepReport& r) { return static_cast<double>(r.unconverged); }, "unsolved",
     ReportGroup::Doubt, 4, steps},
    {"residual", "1", [](const StepReport& r) { return static_cast<double>(r.solve.residual); }},
    {"worst_residual", "1", [](const StepReport& r) { return r.worst_residual; }, "residual", ReportGroup::Doubt, 4},
    {"energy_excess", "J", [](const StepReport& r) { return r.energy_excess; }, "excess", ReportGroup::Doubt, 4},
    {"heated_step", "", [](const StepReport& r) { return static_cast<double>(r.heated_step); }},
    {"step_time", "us", [](const StepReport& r) { return micro * r.times.step; }, "integrate", ReportGroup::Stages, 1,
     total_time},
    {"build_time", "us", [](const StepReport& r) { return micro * r.times.build; }, "build", ReportGroup::Stages, 1,
     total_time},
    {"traverse_time", "us", [](const StepReport& r) { return micro * r.times.traverse; }, "traverse",
     ReportGroup::Stages, 1, total_time},
    {"narrow_time", "us", [](const StepReport& r) { return micro * r.times.narrow; }, "narrow phase",
     ReportGroup::Stages, 1, total_time},
    {"respond_time", "us", [](const StepReport& r) { return micro * r.times.respond; }, "response", ReportGroup::Stages,
     1, total_time},
    {"total_time", "us", total_time},
    {"force_evaluations", "", [](const StepReport& r) { return static_cast<double>(r.solve.force_evaluations); }},
    {"iterations", "", [](const StepReport& r) { return static_cast<double>(r.solve.iterations); }},
    {"nodes", "", nodes},
    {"visited", "", [](const StepReport& r) { return static_cast<double>(r.traversal.visited); }},
    {"volume_tests", "", [](const StepReport& r) { return static_cast<double>(r.traversal.volume_tests); },
     "node tests", ReportGroup::Hierarchy, 3, nodes},
    {"pruned", "", [](const StepReport& r) { return static_cast<double>(r.traversal.pruned); }},
    {"leaves", "", [](const StepReport& r) { return static_cast<double>(r.traversal.leaves); }},
    {"candidates", "", candidates, "candidates", ReportGroup::Hierarchy, 2},
    {"false_candidates", "", [](const StepReport& r) { return static_cast<double>(r.false_candidates); },
     "false positives", ReportGroup::Hierarchy, 1, candidates},
    {"contacts", "", [](const StepReport& r) { return static_cast<double>(r.contacts); }, "contacts",
     ReportGroup::Hierarchy, 3},
    {"ground_visited", "", [](const StepReport& r) { return static_cast<double>(r.ground.visited); }},
    {"ground_pruned", "", [](const StepReport& r) { return static_cast<double>(r.ground.pruned); }},
    {"solid_visited", "", [](const StepReport& r) { return static_cast<double>(r.solids.visited); }},
    {"solid_pruned", "", [](const StepReport& r) { return static_cast<double>(r.solids.pruned); }},
    {"penetration", "m", [](const StepReport& r) { return r.penetration; }, "penetration", ReportGroup::Hierarchy, 1},
    {"contact_residual", "m", [](const StepReport& r) { return r.contact_residual; }},
    {"contact_sweeps", "", [](const StepReport& r) { return static_cast<double>(r.contact_sweeps); }},
    {"stopped", "", stopped, "stopped at", ReportGroup::Limit, 2},
    {"false_contacts", "", [](const StepReport& r) { return static_cast<double>(r.false_contacts); }, "false nodes",
     ReportGroup::Limit, 2, stopped},
    {"missed_penetration", "m", [](const StepReport& r) { return r.missed_penetration; }, "missed", ReportGroup::Limit,
     2},
    {"pairs_time", "us", [](const StepReport& r) { return micro * r.times.pairs; }, "pairs", ReportGroup::Pairs, 1,
     total_time},
    {"pair_tests", "", [](const StepReport& r) { return static_cast<double>(r.between_cloths.volume_tests); },
     "pair tests", ReportGroup::Pairs, 1},
    {"listed_pairs", "", [](const StepReport& r) { return static_cast<double>(r.listed_pairs); }, "near",
     ReportGroup::Pairs, 2},
    {"pairs", "", [](const StepReport& r) { return static_cast<double>(r.pairs); }, "touching pairs",
     ReportGroup::Pairs, 2},
    {"held_back", "", [](const StepReport& r) { return static_cast<double>(r.held_back); }, "held back",
     ReportGroup::Pairs, 2},
    {"rms_speed", "m/s", [](const StepReport& r) { return r.rms_speed; }},
    {"stretch", "1", [](const StepReport& r) { return r.stretch; }, "stretch", ReportGroup::Energy, 3},
    {"stretch_excess", "1", [](const StepReport& r) { return r.stretch_excess; }},
    {"kinetic", "J", [](const StepReport& r) { return r.energy.kinetic; }, "kinetic", ReportGroup::Energy, 2},
    {"gravity", "J", [](const StepReport& r) { return r.energy.gravity; }, "gravity", ReportGroup::Energy, 1},
    {"spring", "J", [](const StepReport& r) { return r.energy.spring; }, "spring", ReportGroup::Energy, 1},
    {"energy", "J", [](const StepReport& r) { return r.energy.total(); }, "total", ReportGroup::Energy, 2},
    {"damping_loss", "J", [](const StepReport& r) { return r.balance.damping; }, "to damping", ReportGroup::Balance, 1},
    {"drag_loss", "J", [](const StepReport& r) { return r.balance.drag; }, "to drag", ReportGroup::Balance, 1},
    {"contact_loss", "J", [](const StepReport& r) { return r.balance.contact; }, "to contact", ReportGroup::Balance, 1},
    {"held_loss", "J", [](const StepReport& r) { return r.balance.held; }, "to fail-safe", ReportGroup::Balance, 1},
    {"integrator_loss", "J", [](const StepReport& r) { return r.balance.integrator; }, "integrator loss",
     ReportGroup::Balance, 1},
    {"wind_work", "J", [](const StepReport& r) { return r.balance.wind; }, "from wind", ReportGroup::Balance, 1},
    {"hand_work", "J", [](const StepReport& r) { return r.balance.hand; }, "from hand", ReportGroup::Balance, 1},
    {"pin_work", "J", [](const StepReport& r) { return r.balance.pins; }, "from pins", ReportGroup::Balance, 1},
    {"ball_work", "J", [](const StepReport& r) { return r.balance.ball; }, "from ball", ReportGroup::Balance, 1},
    {"asleep", "", [](const StepReport& r) { return r.asleep ? 1.0 : 0.0; }},
    {"diverged", "", [](const StepReport& r) { return r.status == Status::Diverged ? 1.0 : 0.0; }},
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
