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

/// One of the five tests.
struct Test {
    const char* name;  ///< with its unit
    double (*figure)(const OriginalRow& row);
    double factor;  ///< from the table's unit to that of the name
    int digits;
};
constexpr Test five_tests[] = {
    {"execution time of a frame [ms]", [](const OriginalRow& row) { return row.execution.median; }, 1e3, 4},
    {"frame rate [1/s]", [](const OriginalRow& row) { return row.rate; }, 1, 3},
    {"OpenGL calls a frame", [](const OriginalRow& row) { return row.gl_calls; }, 1, 6},
    {"CPU use [%]", [](const OriginalRow& row) { return row.cpu; }, 100, 3},
    {"vertices a frame", [](const OriginalRow& row) { return row.vertices; }, 1, 6}};

/// Quartiles of a figure over the rows of a volume; nothing where no row has it.
/// @param drawn only of rows with or without bounds in the picture
template <class Figure>
std::optional<Quartiles> figure_of(const OriginalRows& rows, const std::string& volume, const Figure& figure,
                                   std::optional<bool> drawn = {}) {
    std::vector<double> values;
    for (const OriginalRow& row : rows) {
        if (row.volume != volume || (drawn && *drawn != row.bounds_drawn)) continue;
        if (!std::isnan(figure(row))) values.push_back(figure(row));
    }
    if (values.empty()) return std::nullopt;
    return quartiles_of(std::move(values));
}

/// The same of a search, which is timed without drawing.
std::optional<Quartiles> figure_of(const OriginalRows& rows, const std::string& volume,
                                   OriginalSearch OriginalRow::*tree, double OriginalSearch::*figure) {
    return figure_of(rows, volume, [=](const OriginalRow& row) { return (row.*tree).*figure; });
}

std::string bar(int test, double position, const std::string& volume, bool drawn, const Quartiles& figure,
                double factor, int digits) {
    return fmt::format("{},{},{},{},{:.8g},{:.8g},{:.8g},{:.{}g}\n", test, position, volume, drawn ? 1 : 0,
                       factor * figure.median, factor * figure.lower, factor * figure.upper, factor * figure.median,
                       digits);
}

}  // namespace

std::vector<Chart> original_charts(const OriginalRows& rows) {
    std::string bars = "test,position,volume,drawn,median,lower,upper,text\n";
    for (int number = 1; const Test& test : five_tests) {
        for (double position = 0; const OriginalWay& way : original_ways) {
            const auto figure = figure_of(rows, way.volume, test.figure, way.bounds_drawn);
            if (figure) bars += bar(number, position, way.volume, way.bounds_drawn, *figure, test.factor, test.digits);
            ++position;
        }
        ++number;
    }
    double position = 0;
    for (const auto tree : {&OriginalRow::leaves, &OriginalRow::single}) {
        for (const auto figure : {&OriginalSearch::build, &OriginalSearch::search}) {
            for (const char* volume : {"sphere", "aabb"}) {
                if (const auto found = figure_of(rows, volume, tree, figure))
                    bars += bar(6, position, volume, false, *found, 1e6, 2);
                ++position;
            }
            ++position;
        }
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
