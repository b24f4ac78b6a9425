#include <map>
#include <tuple>

#include "hierarchy_parts.h"
#include "hierarchy_report.h"
#include "lab/experiments.h"

namespace drape {
namespace {

std::vector<HierarchyCase> hierarchy_cases(bool quick) {
    const auto motions = std::make_shared<Motions>();
    std::vector<HierarchyCase> all;
    for (const auto part : {fit_cases, level_cases, budget_cases, break_even_cases, size_cases}) {
        for (HierarchyCase& one : part(quick, motions)) all.push_back(std::move(one));
    }
    return all;
}

/// Updates are compared over frames: all of them need the same ones.
std::string flaw_of_hierarchy_case(const std::vector<HierarchyRow>& rows) {
    using Key = std::tuple<std::string, std::string, double>;
    std::map<Key, std::map<std::string, std::vector<double>>> frames;
    for (const HierarchyRow& row : rows_with(rows, &HierarchyRow::part, "break_even")) {
        frames[{row.scene, row.volume, row.interval_s}][row.update].push_back(row.frame);
    }
    for (auto& [key, updates] : frames) {
        for (const std::string& update : names_of<UpdateKind>()) {
            if (updates[update] == updates[names_of<UpdateKind>().front()]) continue;
            return "the rows of update '" + update + "' are not of the same frames as those of '" +
                   names_of<UpdateKind>().front() + "'";
        }
    }
    return "";
}

}  // namespace

MotionWanted screen_frames(const HierarchyScene& scene, int frames) {
    return {.scene = scene.name, .from = scene.from, .interval = 1.0 / 60, .frames = frames};
}

Experiment hierarchy_experiment() {
    return ExperimentOf<HierarchyRow>{
        "hierarchy",           "what does a tighter hierarchy cost, and what does it save?",
        hierarchy_format(),    hierarchy_cases,
        hierarchy_charts,      hierarchy_summary,
        flaw_of_hierarchy_case}
        .as_table();
}

}  // namespace drape
