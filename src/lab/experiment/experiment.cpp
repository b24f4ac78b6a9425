#include "experiment.h"

#include <fmt/ranges.h>

#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

std::size_t place_of(const Experiment& experiment, const std::string& column) {
    const auto found = std::ranges::find(experiment.columns, column, &Column::name);
    DRAPE_ASSERT(found != experiment.columns.end());
    return static_cast<std::size_t>(found - experiment.columns.begin());
}

/// Words stand for themselves but for "none", numbers with the names of their columns.
std::string label_of(const Experiment& experiment, const TableRow& row) {
    std::vector<std::string> parts;
    for (const std::string& column : experiment.summary.by) {
        const std::string& cell = row[place_of(experiment, column)];
        const auto number = parse_real(cell);
        if (cell.empty() || cell == "none" || (number && std::isnan(*number))) continue;
        parts.push_back(number ? column + " " + cell : cell);
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// "step_s 0.001 to 0.05", after a comma; empty if no row has a number there.
std::string range_of(const Experiment& experiment, const std::string& column, const std::vector<TableRow>& rows) {
    const std::size_t place = place_of(experiment, column);
    std::vector<double> numbers;
    for (const TableRow& row : rows) {
        if (const double number = number_in(row[place]); !std::isnan(number)) numbers.push_back(number);
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
    for (const ExperimentPart& part : parts) std::ranges::move(part.cases(quick), std::back_inserter(all));
    return all;
}

std::vector<Chart> Experiment::charts(const std::vector<TableRow>& table) const {
    const Rows rows = rows_of(columns, table);
    std::vector<Chart> all;
    for (const ExperimentPart& part : parts) {
        const Rows own = part.name.empty() ? rows : rows_with(rows, "part", part.name);
        if (!own.empty() && part.charts) std::ranges::move(part.charts(own), std::back_inserter(all));
    }
    return all;
}

std::string summary_of(const Experiment& experiment, const std::vector<TableRow>& rows) {
    const auto label = [&experiment](const TableRow& row) { return label_of(experiment, row); };
    const auto groups = groups_of(rows, label);
    std::string text;
    for (const std::string& name : words_of(rows, label)) {
        const std::vector<TableRow>& group = groups.at(name);
        text += fmt::format("{}: {} row{}", name, group.size(), group.size() == 1 ? "" : "s");
        for (const std::string& column : experiment.summary.of) text += range_of(experiment, column, group);
        text += "\n";
    }
    return text;
}

}  // namespace drape
