#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "original.h"

namespace drape {
namespace {

/// Medians closer than this are called equal: about what their ratio varies by from run to run on a shared machine.
constexpr double alike = 0.1;

/// One of the five tests.
struct Test {
    const char* name;  ///< with its unit
    double (*figure)(const OriginalRow& row);
    double factor;     ///< from the table's unit to that of the name
    double published;  ///< by the dissertation, of its own prototype, in the unit of the name
    int digits;
};
constexpr Test five_tests[] = {
    {"execution time of a frame [ms]", [](const OriginalRow& row) { return row.execution.median; }, 1e3, 235.258, 4},
    {"frame rate [1/s]", [](const OriginalRow& row) { return row.rate; }, 1, 22, 3},
    {"OpenGL calls a frame", [](const OriginalRow& row) { return row.gl_calls; }, 1, 15'000, 6},
    {"CPU use [%]", [](const OriginalRow& row) { return row.cpu; }, 100, 34, 3},
    {"vertices a frame", [](const OriginalRow& row) { return row.vertices; }, 1, 42'000, 6}};

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

/// A half of the conclusion: "holds (9.1 us against 5.0 us with boxes, 1.8 times)".
std::string half(double sphere, double aabb, bool sphere_is_more) {
    const double ratio = sphere / aabb;
    const bool equal = ratio < 1 + alike && ratio > 1 / (1 + alike);
    return fmt::format("{} ({:.3g} us against {:.3g} us with boxes, {:.3g} times)",
                       equal                           ? "is too close to tell"
                       : (ratio > 1) == sphere_is_more ? "holds"
                                                       : "does not hold",
                       1e6 * sphere, 1e6 * aabb, ratio);
}

std::string conclusion(const OriginalRows& rows, OriginalSearch OriginalRow::*tree) {
    const auto of = [&](const char* volume) {
        const auto median = [&](double OriginalSearch::*figure) {
            return figure_of(rows, volume, tree, figure).value_or(Quartiles{}).median;
        };
        return OriginalSearch{.build = median(&OriginalSearch::build), .search = median(&OriginalSearch::search)};
    };
    return original_conclusion(of("sphere"), of("aabb"));
}

std::string bar(int test, double position, const std::string& volume, bool drawn, const Quartiles& figure,
                double factor, int digits) {
    return fmt::format("{},{},{},{},{:.8g},{:.8g},{:.8g},{:.{}g}\n", test, position, volume, drawn ? 1 : 0,
                       factor * figure.median, factor * figure.lower, factor * figure.upper, factor * figure.median,
                       digits);
}

}  // namespace

std::string original_conclusion(const OriginalSearch& sphere, const OriginalSearch& aabb) {
    return fmt::format(
        "the dissertation's conclusion that spheres are more expensive to build {}, and that they are faster to search "
        "{}.",
        half(sphere.build, aabb.build, true), half(sphere.search, aabb.search, false));
}

std::string original_summary(const OriginalRows& rows) {
    std::string text = fmt::format("{:32}", "");
    for (const OriginalWay& way : original_ways) {
        text += fmt::format("{:14}", way.volume + (way.bounds_drawn ? " drawn" : ""));
    }
    text += "dissertation\n";
    for (const Test& test : five_tests) {
        text += fmt::format("{:32}", test.name);
        for (const OriginalWay& way : original_ways) {
            const auto figure = figure_of(rows, way.volume, test.figure, way.bounds_drawn);
            text +=
                fmt::format("{:14}", figure ? fmt::format("{:.{}g}", test.factor * figure->median, test.digits) : "-");
        }
        text += fmt::format("{}\n", test.published);
    }
    return text + "(drawn: with the bounds of a level in the picture)\nWith the leaves that the scene has: " +
           conclusion(rows, &OriginalRow::leaves) +
           "\nWith a tree down to single cells: " + conclusion(rows, &OriginalRow::single) + "\n";
}

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
