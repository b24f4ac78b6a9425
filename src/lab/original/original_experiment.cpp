#include "original.h"

#include <memory>

#include "drape/base/resources.h"
#include "drape/base/run_program.h"
#include "lab/experiments.h"

namespace drape {
namespace {

std::vector<CaseOf<OriginalRow>> original_cases(bool quick) {
    const OriginalPlan plan{.frames = quick ? 12 : 40, .passes = quick ? 5 : 15};
    const auto told = std::make_shared<bool>(false);
    const auto run = [plan, told] {
        const auto program = program_folder() / "drape-capture";
        bool draws = false;
        auto rows = original_rows(plan, program, draws);
        if (!draws && !*told) {
            tell("There is no " + program.string() + ": frame rate, calls, CPU use and vertices stay empty.");
            *told = true;
        }
        return rows;
    };
    return std::vector<CaseOf<OriginalRow>>(quick ? 3 : 7, run);
}

}  // namespace

Experiment original_experiment() {
    using Row = OriginalRow;
    using Search = OriginalSearch;
    const auto if_drawn = [](const char* name) { return number_column(name).or_words({""}); };
    return ExperimentOf<Row>{"original",
                             "spheres or boxes: do the dissertation's five tests come out as they did?",
                             {8,
                              {{word_column("volume", {"sphere", "aabb"}), &Row::volume},
                               {word_column("bounds_drawn", {"0", "1"}), &Row::bounds_drawn},
                               {number_column("execution_s"), &Row::execution},
                               {if_drawn("rate_per_s"), &Row::rate},
                               {if_drawn("gl_calls"), &Row::gl_calls},
                               {if_drawn("cpu"), &Row::cpu},
                               {if_drawn("vertices"), &Row::vertices},
                               {number_column("build_s"), &Row::leaves, &Search::build},
                               {number_column("search_s"), &Row::leaves, &Search::search},
                               {number_column("exact_s"), &Row::leaves, &Search::exact},
                               {number_column("candidates"), &Row::leaves, &Search::candidates},
                               {number_column("single_build_s"), &Row::single, &Search::build},
                               {number_column("single_search_s"), &Row::single, &Search::search},
                               {number_column("single_exact_s"), &Row::single, &Search::exact},
                               {number_column("single_candidates"), &Row::single, &Search::candidates}}},
                             {{"volume", "bounds_drawn"},
                              {"execution_s", "rate_per_s", "gl_calls", "cpu", "vertices", "build_s", "search_s",
                               "single_build_s", "single_search_s"}},
                             {{"", original_cases, original_charts}}};
}

}  // namespace drape
