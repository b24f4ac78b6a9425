#include "original_experiment.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "drape/base/numbers.h"
#include "drape/base/resources.h"

namespace drape {
namespace {

namespace at = original_column;

/// Medians closer than this are called equal: about what their ratio varies by from run to run on a shared machine.
constexpr double alike = 0.1;

std::vector<ExperimentCase> cases(bool quick) {
    const OriginalPlan plan{.frames = quick ? 12 : 40, .passes = quick ? 5 : 15};
    const auto told = std::make_shared<bool>(false);
    const auto run = [plan, told] {
        const auto program = program_folder() / "drape-capture";
        bool draws = false;
        auto rows = original_rows(plan, program, draws);
        if (!draws && !*told) {
            std::cerr << "There is no " << program.string()
                      << ": frame rate, calls, CPU use and vertices stay empty.\n";
            *told = true;
        }
        return rows;
    };
    return std::vector<ExperimentCase>(quick ? 3 : 7, run);
}

std::vector<Column> columns() {
    const auto if_drawn = [](const char* name) { return number_column(name).or_words({""}); };
    return {word_column("volume", {"sphere", "aabb"}),
            word_column("bounds_drawn", {"0", "1"}),
            number_column("execution_s"),
            number_column("execution_lower_s"),
            number_column("execution_upper_s"),
            if_drawn("rate_per_s"),
            if_drawn("gl_calls"),
            if_drawn("cpu"),
            if_drawn("vertices"),
            number_column("build_s"),
            number_column("search_s"),
            number_column("exact_s"),
            number_column("candidates"),
            number_column("single_build_s"),
            number_column("single_search_s"),
            number_column("single_exact_s"),
            number_column("single_candidates")};
}

/// A case compares: it needs all that it compares.
std::string flaw_of_case(const std::vector<TableRow>& rows) {
    for (const OriginalWay& way : original_ways()) {
        const auto is_it = [&way](const TableRow& row) {
            return row[at::Volume] == way.volume && row[at::BoundsDrawn] == (way.bounds_drawn ? "1" : "0");
        };
        const auto count = std::ranges::count_if(rows, is_it);
        if (count == 1) continue;
        return std::to_string(count) + " rows of volume '" + way.volume + "' with bounds_drawn '" +
               (way.bounds_drawn ? "1" : "0") + "': allowed 1";
    }
    return "";
}

/// A half of the conclusion: "holds (1.8 times, 9.1 us against 5.0 us)".
std::string half(double sphere, double aabb, bool sphere_is_more) {
    const double ratio = sphere / aabb;
    const std::string figures = " (" + real_text(1e6 * sphere, 3) + " us against " + real_text(1e6 * aabb, 3) +
                                " us with boxes, " + real_text(ratio, 3) + " times)";
    if (ratio < 1 + alike && ratio > 1 / (1 + alike)) return "is too close to tell" + figures;
    return ((ratio > 1) == sphere_is_more ? "holds" : "does not hold") + figures;
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

/// The dissertation's table, with its prototype beside.
std::string five_tests(const std::vector<TableRow>& rows) {
    std::string text = padded("", 32);
    for (const OriginalWay& way : original_ways()) text += padded(way.volume + (way.bounds_drawn ? " drawn" : ""), 14);
    text += "dissertation\n";
    for (const OriginalTest& test : original_tests) {
        text += padded(test.name, 32);
        for (const OriginalWay& way : original_ways()) {
            const auto figure = original_figure(rows, way, test.column);
            text += padded(figure ? real_text(test.factor * figure->median, test.digits) : "-", 14);
        }
        text += real_text(test.published) + "\n";
    }
    return text + "(drawn: with the bounds of a level in the picture)\n";
}

OriginalSearch search_of(const std::vector<TableRow>& rows, const std::string& volume, std::size_t build,
                         std::size_t search) {
    return {.build = original_search_figure(rows, volume, build).median,
            .search = original_search_figure(rows, volume, search).median};
}

std::string summary(const std::vector<TableRow>& rows) {
    if (rows.empty()) return "";
    const auto verdict = [&rows](std::size_t build, std::size_t search) {
        return original_verdict(search_of(rows, "sphere", build, search), search_of(rows, "aabb", build, search));
    };
    return five_tests(rows) + "With the leaves that the scene has: " + verdict(at::Build, at::Search) +
           "\nWith a tree down to single cells: " + verdict(at::SingleBuild, at::SingleSearch) + "\n";
}

}  // namespace

const std::vector<OriginalWay>& original_ways() {
    static const std::vector<OriginalWay> ways{{"sphere", false}, {"aabb", false}, {"sphere", true}, {"aabb", true}};
    return ways;
}

std::optional<Quartiles> original_figure(const std::vector<TableRow>& rows, const OriginalWay& way,
                                         std::size_t column) {
    std::vector<double> values;
    for (const TableRow& row : rows) {
        const bool drawn = row[at::BoundsDrawn] == "1";
        if (row[at::Volume] != way.volume || drawn != way.bounds_drawn) continue;
        if (!row[column].empty()) values.push_back(number_in(row[column]));
    }
    if (values.empty()) return std::nullopt;
    return quartiles_of(std::move(values));
}

Quartiles original_search_figure(const std::vector<TableRow>& rows, const std::string& volume, std::size_t column) {
    std::vector<double> values;
    for (const TableRow& row : rows) {
        if (row[at::Volume] == volume) values.push_back(number_in(row[column]));
    }
    return quartiles_of(std::move(values));
}

std::string original_verdict(const OriginalSearch& sphere, const OriginalSearch& aabb) {
    return "the dissertation's conclusion that spheres are more expensive to build " +
           half(sphere.build, aabb.build, true) + ", and that they are faster to search " +
           half(sphere.search, aabb.search, false) + ".";
}

std::vector<TableRow> original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws) {
    draws = true;
    std::vector<TableRow> rows;
    const auto text = [](double value) { return real_text(value, 8); };
    // What is compared is timed close together: the clock of a processor that others use comes and goes
    std::vector<OriginalTimes> all_times;
    for (const OriginalWay& way : original_ways()) all_times.push_back(time_original(way, plan));
    for (std::size_t k = 0; k < all_times.size(); ++k) {
        const OriginalWay& way = original_ways()[k];
        const OriginalTimes& times = all_times[k];
        std::optional<OriginalPictures> pictures;
        if (draws) pictures = draw_original(way, plan, program);
        draws = pictures.has_value();
        TableRow row{way.volume, way.bounds_drawn ? "1" : "0", text(times.execution.median),
                     text(times.execution.lower), text(times.execution.upper)};
        for (const auto figure : {&OriginalPictures::rate, &OriginalPictures::gl_calls, &OriginalPictures::cpu,
                                  &OriginalPictures::vertices}) {
            row.push_back(pictures ? text((*pictures).*figure) : "");
        }
        for (const OriginalSearch& search : {times.scene, times.single}) {
            for (const double figure : {search.build, search.search, search.exact, search.candidates}) {
                row.push_back(text(figure));
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

Experiment original_experiment() {
    return {"original",      "spheres or boxes: do the dissertation's five tests come out as they did?",
            columns(),       cases,
            original_charts, summary,
            flaw_of_case};
}

}  // namespace drape
