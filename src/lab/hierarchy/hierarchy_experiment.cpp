#include "hierarchy_experiment.h"

#include "hierarchy_parts.h"
#include "hierarchy_row.h"
#include "hierarchy_summary.h"

namespace drape {
namespace {

std::vector<ExperimentCase> cases(bool quick) {
    const auto motions = std::make_shared<Motions>();
    std::vector<ExperimentCase> all;
    for (const auto part : {fit_cases, level_cases, budget_cases, break_even_cases, size_cases}) {
        for (ExperimentCase& one : part(quick, motions)) all.push_back(std::move(one));
    }
    return all;
}

}  // namespace

MotionWanted screen_frames(const HierarchyScene& scene, int frames) {
    return {.scene = scene.name, .from = scene.from, .interval = 1.0 / 60, .frames = frames};
}

Experiment hierarchy_experiment() {
    return {"hierarchy",         "what does a tighter hierarchy cost, and what does it save?",
            hierarchy_columns(), cases,
            hierarchy_charts,    hierarchy_summary};
}

}  // namespace drape
