#include "original.h"

#include <algorithm>
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

RowFormat<OriginalRow> original_format() {
    using Row = OriginalRow;
    const auto if_drawn = [](const char* name) { return number_column(name).or_words({""}); };
    return {8,
            {{word_column("volume", {"sphere", "aabb"}), &Row::volume},
             {word_column("bounds_drawn", {"0", "1"}), &Row::drawn},
             {number_column("execution_s"), &Row::execution},
             {number_column("execution_lower_s"), &Row::execution_lower},
             {number_column("execution_upper_s"), &Row::execution_upper},
             {if_drawn("rate_per_s"), &Row::rate},
             {if_drawn("gl_calls"), &Row::gl_calls},
             {if_drawn("cpu"), &Row::cpu},
             {if_drawn("vertices"), &Row::vertices},
             {number_column("build_s"), &Row::build},
             {number_column("search_s"), &Row::search},
             {number_column("exact_s"), &Row::exact},
             {number_column("candidates"), &Row::candidates},
             {number_column("single_build_s"), &Row::single_build},
             {number_column("single_search_s"), &Row::single_search},
             {number_column("single_exact_s"), &Row::single_exact},
             {number_column("single_candidates"), &Row::single_candidates}}};
}

/// A case compares: it needs all that it compares.
std::string flaw_of_original_case(const OriginalRows& rows) {
    for (const OriginalWay& way : original_ways) {
        const auto count = std::ranges::count_if(rows, [&way](const OriginalRow& row) {
            return row.volume == way.volume && (row.drawn > 0) == way.bounds_drawn;
        });
        if (count == 1) continue;
        return std::to_string(count) + " rows of volume '" + way.volume + "' with bounds_drawn '" +
               (way.bounds_drawn ? "1" : "0") + "': allowed 1";
    }
    return "";
}

}  // namespace

OriginalRows original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws) {
    OriginalRows rows;
    // What is compared is timed close together: the clock of a processor that others use comes and goes
    for (const OriginalWay& way : original_ways) rows.push_back(time_original(way, plan));
    draws = true;
    for (std::size_t k = 0; k < rows.size() && draws; ++k) {
        draws = draw_original(original_ways[k], plan, program, rows[k]);
    }
    return rows;
}

Experiment original_experiment() {
    return ExperimentOf<OriginalRow>{
        "original",           "spheres or boxes: do the dissertation's five tests come out as they did?",
        original_format(),    original_cases,
        original_charts,      original_summary,
        flaw_of_original_case}
        .as_table();
}

}  // namespace drape
