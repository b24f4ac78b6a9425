#include "experiment.h"

#include <fmt/ranges.h>

#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

/// Words stand for themselves but for "none", numbers with the names of their columns.
std::string label_of(const Experiment& experiment, const Row& row) {
    std::vector<std::string> parts;
    for (const std::string& column : experiment.summary.by) {
        const auto found = std::ranges::find(experiment.columns, column, &Column::name);
        DRAPE_ASSERT(found != experiment.columns.end());
        const std::string cell = row.text(*found, experiment.digits);
        const auto number = parse_real(cell);
        if (cell.empty() || cell == "none" || (number && std::isnan(*number))) continue;
        parts.push_back(number ? column + " " + cell : cell);
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// "step_s 0.001 to 0.05", after a comma; empty if no row has a number there.
std::string range_of(const Rows& rows, const std::string& column) {
    std::vector<double> numbers;
    for (const Row& row : rows) {
        if (!std::isnan(row.number(column))) numbers.push_back(row.number(column));
    }
    if (numbers.empty()) return "";
    const auto [least, most] = std::ranges::minmax(numbers);
    const std::string text = ", " + column + " " + real_text(least, 3);
    return least == most ? text : text + " to " + real_text(most, 3);
}

}  // namespace

ChartsOfRows charts_by(const char* column, const char* script) {
    return [column, script](const Rows& rows) {
        std::vector<Chart> charts;
        for (const std::string& word : words_of(rows, column)) {
            charts.push_back({.name = script + ("_" + word), .values = {{column, word}}, .script = script});
        }
        return charts;
    };
}

ExperimentCases Experiment::cases(bool quick) const {
    ExperimentCases all;
    for (const ExperimentPart& part : parts) {
        for (const ExperimentCase& run : part.cases(quick)) {
            all.push_back([run, name = part.name] {
                Rows rows = run();
                for (Row& row : rows) {
                    if (!name.empty()) row.set("part", name);
                }
                return rows;
            });
        }
    }
    return all;
}

std::vector<Chart> Experiment::charts(const Rows& rows) const {
    std::vector<Chart> all;
    for (const ExperimentPart& part : parts) {
        const Rows own = part.name.empty() ? rows : rows_with(rows, "part", part.name);
        if (!own.empty() && part.charts) std::ranges::move(part.charts(own), std::back_inserter(all));
    }
    return all;
}

std::string summary_of(const Experiment& experiment, const Rows& rows) {
    std::vector<std::string> names;
    std::map<std::string, Rows> groups;
    for (const Row& row : rows) {
        const std::string name = label_of(experiment, row);
        if (!groups.contains(name)) names.push_back(name);
        groups[name].push_back(row);
    }
    std::string text;
    for (const std::string& name : names) {
        const Rows& group = groups.at(name);
        text += fmt::format("{}: {} row{}", name, group.size(), group.size() == 1 ? "" : "s");
        for (const std::string& column : experiment.summary.of) text += range_of(group, column);
        text += "\n";
    }
    return text;
}

}  // namespace drape
