#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <optional>

#include "drape/base/resources.h"
#include "drape/base/run_program.h"
#include "lab/experiments.h"
#include "original.h"

namespace drape {
namespace {

/// What a bar of the chart shows, in the unit that the chart says.
struct Figure {
    int test;
    const char* column;
    double factor;  ///< from the table's unit
    int digits;
};

/// The dissertation's five tests, each without the bounds in the picture and with them.
constexpr Figure five_tests[] = {{1, "execution_s", 1e3, 4},
                                 {2, "rate_per_s", 1, 3},
                                 {3, "gl_calls", 1, 6},
                                 {4, "cpu", 100, 3},
                                 {5, "vertices", 1, 6}};

/// Build and search, which are timed without drawing, with the scene's leaves and down to single cells.
constexpr Figure searches_alone[] = {
    {6, "build_s", 1e6, 2}, {6, "search_s", 1e6, 2}, {6, "single_build_s", 1e6, 2}, {6, "single_search_s", 1e6, 2}};

/// A bar over the rows of a volume; nothing where no row has the figure.
/// @param drawn only of rows with or without bounds in the picture
std::string bar(const Rows& rows, const Figure& figure, int position, const std::string& volume,
                std::optional<bool> drawn) {
    std::vector<double> values;
    for (const Row& row : rows_with(rows, "volume", volume)) {
        if (drawn && row.word("bounds_drawn") != (*drawn ? "1" : "0")) continue;
        if (const double value = row.number(figure.column); !std::isnan(value)) values.push_back(value);
    }
    if (values.empty()) return "";
    const auto [lower, median, upper] = quartiles_of(std::move(values));
    const double factor = figure.factor;
    return fmt::format("{},{},{},{},{:.8g},{:.8g},{:.8g},{:.{}g}\n", figure.test, position, volume,
                       drawn.value_or(false) ? 1 : 0, factor * median, factor * lower, factor * upper, factor * median,
                       figure.digits);
}

std::vector<Chart> original_charts(const Rows& rows) {
    std::string bars = "test,position,volume,drawn,median,lower,upper,text\n";
    for (const Figure& test : five_tests) {
        for (int position = 0; const OriginalWay& way : original_ways) {
            bars += bar(rows, test, position++, way.volume, way.bounds_drawn);
        }
    }
    for (int position = 0; const Figure& search : searches_alone) {
        for (const char* volume : {"sphere", "aabb"}) bars += bar(rows, search, position++, volume, {});
        ++position;
    }
    return {
        {"original",
         "original",
         "One build and one search, with the scene's leaves of 7 x 7 cells and with a tree down to single cells; the "
         "CPU time of all steps of a frame, without drawing; and the frame rate. Medians over runs, with quartiles. "
         "Hatched: the bounds of a level are in the picture, as the original drew its spheres.",
         {},
         bars}};
}

ExperimentCases original_cases(bool quick) {
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
    return ExperimentCases(quick ? 3 : 7, run);
}

}  // namespace

Experiment original_experiment() {
    const auto if_drawn = [](const char* name) { return number_column(name).or_words({""}); };
    return {"original",
            "spheres or boxes: do the dissertation's five tests come out as they did?",
            8,
            {word_column("volume", {"sphere", "aabb"}), word_column("bounds_drawn", {"0", "1"}),
             number_column("execution_s").with_quartiles(),  // CPU time of all steps of a frame
             if_drawn("rate_per_s"),
             if_drawn("gl_calls"),  // of a frame
             if_drawn("cpu"),       // processor time over wall time: more than 1 where several threads draw
             if_drawn("vertices"), number_column("build_s"), number_column("search_s"), number_column("exact_s"),
             number_column("candidates"), number_column("single_build_s"), number_column("single_search_s"),
             number_column("single_exact_s"), number_column("single_candidates")},
            {{"volume", "bounds_drawn"},
             {"execution_s", "rate_per_s", "gl_calls", "cpu", "vertices", "build_s", "search_s", "single_build_s",
              "single_search_s"}},
            {{"", original_cases, original_charts}}};
}

}  // namespace drape
