#include <fmt/core.h>

#include <cmath>
#include <optional>

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

}  // namespace drape
