#include <fmt/core.h>

#include "combination.h"
#include "drape/base/input_error.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// A combination, by brute force and all of its trees.
struct CombinationRow : Combination, CombinationRun {
    std::size_t trees = 0;  ///< with the same bits as brute force
    std::string flaw;
};

std::vector<CombinationRow> run_trees(const Combination& combination, const std::vector<SearchTree>& trees) {
    constexpr double simulated_seconds = 2;
    const CombinationRun expected = run_combination(combination, {}, simulated_seconds);
    for (const SearchTree& tree : trees) {
        if (run_combination(combination, tree, simulated_seconds).hash == expected.hash) continue;
        throw RunError(fmt::format("combinations: {}, {}, {}: {}, {} gives other bits than brute force",
                                   name_of(combination.integrator), name_of(combination.response),
                                   combination.continuous ? "continuous" : "discrete", name_of(tree.volume),
                                   name_of(tree.update)));
    }
    return {{combination, expected, trees.size(), flaw_of(expected)}};
}

std::vector<CaseOf<CombinationRow>> combination_cases(bool quick) {
    std::vector<CaseOf<CombinationRow>> all;
    for (const Combination& combination : all_combinations()) {
        const std::size_t number = all.size();
        all.push_back([=] { return run_trees(combination, quick ? std::vector{sampled_tree(number)} : all_trees()); });
    }
    return all;
}

}  // namespace

Experiment combinations_experiment() {
    using Row = CombinationRow;
    return ExperimentOf<Row>{
        "combinations",
        "does every integrator work with every response, volume and update?",
        {4,
         {{name_column<IntegratorKind>("integrator"), &Row::integrator},
          {name_column<ResponseKind>("response"), &Row::response},
          {word_column("detection", {"discrete", "continuous"}), &Row::continuous},
          {whole_column("trees", 1), &Row::trees},
          {positive_column("step_s"), &Row::step},
          {whole_column("touched_steps"), &Row::touched},
          {number_column("penetration_m"), &Row::penetration},
          {number_column("energy_gain_m"), &Row::energy_gain},
          {number_column("speed_m_per_s"), &Row::speed},
          {word_column("flaw", run_flaws()), &Row::flaw}}},
        {{"integrator", "flaw"}, {"trees", "step_s", "penetration_m", "energy_gain_m", "speed_m_per_s"}},
        {{"", combination_cases, {}}}};
}

}  // namespace drape
