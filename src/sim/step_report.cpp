#include "drape/sim/step_report.h"

#include <array>

namespace drape {
namespace {

constexpr double micro = 1e6;  // seconds are shown as microseconds

const std::array<ReportField, 23> fields{{
    {"step", "", [](const StepReport& r) { return static_cast<double>(r.step); }},
    {"time", "s", [](const StepReport& r) { return r.time; }},
    {"step_time", "us", [](const StepReport& r) { return micro * r.times.step; }},
    {"build_time", "us", [](const StepReport& r) { return micro * r.times.build; }},
    {"traverse_time", "us", [](const StepReport& r) { return micro * r.times.traverse; }},
    {"narrow_time", "us", [](const StepReport& r) { return micro * r.times.narrow; }},
    {"respond_time", "us", [](const StepReport& r) { return micro * r.times.respond; }},
    {"total_time", "us", [](const StepReport& r) { return micro * r.times.total(); }},
    {"force_evaluations", "", [](const StepReport& r) { return static_cast<double>(r.solve.force_evaluations); }},
    {"nodes", "", [](const StepReport& r) { return static_cast<double>(r.traversal.nodes); }},
    {"visited", "", [](const StepReport& r) { return static_cast<double>(r.traversal.visited); }},
    {"volume_tests", "", [](const StepReport& r) { return static_cast<double>(r.traversal.volume_tests); }},
    {"leaves", "", [](const StepReport& r) { return static_cast<double>(r.traversal.leaves); }},
    {"candidates", "", [](const StepReport& r) { return static_cast<double>(r.traversal.candidates); }},
    {"contacts", "", [](const StepReport& r) { return static_cast<double>(r.contacts); }},
    {"penetration", "m", [](const StepReport& r) { return r.penetration; }},
    {"rms_speed", "m/s", [](const StepReport& r) { return r.rms_speed; }},
    {"stretch", "", [](const StepReport& r) { return r.stretch; }},
    {"kinetic", "J", [](const StepReport& r) { return static_cast<double>(r.energy.kinetic); }},
    {"gravity", "J", [](const StepReport& r) { return static_cast<double>(r.energy.gravity); }},
    {"spring", "J", [](const StepReport& r) { return static_cast<double>(r.energy.spring); }},
    {"energy", "J", [](const StepReport& r) { return static_cast<double>(r.energy.total()); }},
    {"diverged", "", [](const StepReport& r) { return r.status == Status::Diverged ? 1.0 : 0.0; }},
}};

}  // namespace

std::span<const ReportField> report_fields() { return fields; }

}  // namespace drape
