#include <fmt/core.h>

#include "combination.h"
#include "drape/base/input_error.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// A combination, by all of its trees.
struct CombinationRow {
    std::string integrator, response, detection;
    double trees = 0;  ///< that were run beside brute force, with the same bits
    double step = 0, touched = 0, penetration = 0, energy_gain = 0, speed = 0;
    std::string flaw;
};

constexpr double simulated_seconds = 2;

std::string named(const Combination& combination) {
    return fmt::format("{}, {}, {}", name_of(combination.integrator), name_of(combination.response),
                       combination.continuous ? "continuous" : "discrete");
}

std::vector<CombinationRow> run_trees(const Combination& combination, const std::vector<SearchTree>& trees) {
    const CombinationRun expected = run_combination(combination, {}, simulated_seconds);
    for (const SearchTree& tree : trees) {
        if (run_combination(combination, tree, simulated_seconds).hash == expected.hash) continue;
        throw RunError(fmt::format("combinations: {}: {}, {} gives other bits than brute force", named(combination),
                                   name_of(tree.volume), name_of(tree.update)));
    }
    return {{.integrator = name_of(combination.integrator),
             .response = name_of(combination.response),
             .detection = combination.continuous ? "continuous" : "discrete",
             .trees = static_cast<double>(trees.size()),
             .step = expected.step,
             .touched = expected.touched,
             .penetration = expected.penetration,
             .energy_gain = expected.energy_gain,
             .speed = expected.speed,
             .flaw = flaw_of(expected)}};
}

std::vector<CaseOf<CombinationRow>> combination_cases(bool quick) {
    std::vector<CaseOf<CombinationRow>> all;
    for (const Combination& combination : all_combinations()) {
        const std::size_t number = all.size();
        all.push_back([=] { return run_trees(combination, quick ? std::vector{sampled_tree(number)} : all_trees()); });
    }
    return all;
}

RowFormat<CombinationRow> combination_format() {
    using Row = CombinationRow;
    return {4,
            {{name_column<IntegratorKind>("integrator"), &Row::integrator},
             {name_column<ResponseKind>("response"), &Row::response},
             {word_column("detection", {"discrete", "continuous"}), &Row::detection},
             {whole_column("trees", 1), &Row::trees},
             {positive_column("step_s"), &Row::step},
             {whole_column("touched_steps"), &Row::touched},
             {number_column("penetration_m"), &Row::penetration},
             {number_column("energy_gain_m"), &Row::energy_gain},
             {number_column("speed_m_per_s"), &Row::speed},
             {word_column("flaw", run_flaws()), &Row::flaw}}};
}

std::string combination_summary(const std::vector<CombinationRow>& rows) {
    std::string text = fmt::format("{} combinations, the same bits by every tree as by brute force\n", rows.size());
    for (const CombinationRow& row : rows) {
        if (row.flaw == "none") continue;
        text += fmt::format("{}, {}, {}: {}: penetration {:.3g} mm, energy gain {:.3g} m, speed {:.3g} m/s\n",
                            row.integrator, row.response, row.detection, row.flaw, 1e3 * row.penetration,
                            row.energy_gain, row.speed);
    }
    return text;
}

}  // namespace

Experiment combinations_experiment() {
    return ExperimentOf<CombinationRow>{"combinations",
                                        "does every integrator work with every response, volume and update?",
                                        combination_format(),
                                        combination_cases,
                                        [](const auto&) { return std::vector<Chart>{}; },
                                        combination_summary}
        .as_table();
}

}  // namespace drape
