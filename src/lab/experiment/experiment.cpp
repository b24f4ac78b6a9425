#include "experiment.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

/// The name of a quartile's column beside that of its median: NAME_lower_UNIT.
std::string quartile_name(const std::string& column, const char* mark) {
    return std::string(column).insert(column.find('_'), mark);
}

}  // namespace

Columns quartile_columns(const char* median) {
    return {median, Column{quartile_name(median, "_lower")}, Column{quartile_name(median, "_upper")}};
}

void Row::set(const std::string& column, const Cell& cell) {
    if (const auto* quartiles = std::get_if<Quartiles>(&cell)) {
        set(column, quartiles->median);
        set(quartile_name(column, "_lower"), quartiles->lower);
        set(quartile_name(column, "_upper"), quartiles->upper);
    } else {
        cells_.insert_or_assign(column, std::get<std::string>(cell));
    }
}

void Row::set(const Row& other) {
    for (const auto& [column, cell] : other.cells_) set(column, cell);
}

double Row::number(const std::string& column) const {
    const std::string cell = word(column);
    if (cell.empty()) return no_number;
    if (const auto number = parse_real(cell)) return *number;
    throw InputError("a row has '" + shortened(cell) + "' for the number '" + column + "'");
}

std::vector<std::string> Row::texts(const Columns& columns, int digits) const {
    for (const auto& [name, cell] : cells_) {
        if (std::ranges::find(columns, name, &Column::name) != columns.end()) continue;
        throw RunError("a row has a cell for '" + name + "', and its table no such column");
    }
    std::vector<std::string> texts;
    for (const Column& column : columns) {
        const std::string cell = has(column.name) ? word(column.name) : column.if_none;
        const auto number = parse_real(cell);
        texts.push_back(!number || parse_integer(cell) ? cell
                        : std::isnan(*number)          ? column.if_none
                                                       : real_text(*number, digits));
    }
    return texts;
}

ExperimentCases Experiment::cases(bool quick) const {
    ExperimentCases all;
    for (const ExperimentPart& part : parts) {
        const std::string column = part.name.empty() ? "" : "part";
        for (const ExperimentCase& run : part.cases(quick)) all.push_back(with_column(run, column, part.name));
    }
    return all;
}

std::vector<Chart> Experiment::charts(const Rows& rows) const {
    std::vector<Chart> all;
    for (const ExperimentPart& part : parts) {
        std::set<std::string> drawn;
        for (const Row& row : rows) {
            if (!part.name.empty() && row.word("part") != part.name) continue;
            const std::string word = part.charts_by.empty() ? "" : row.word(part.charts_by);
            if (!drawn.insert(word).second) continue;
            for (Chart chart : part.charts) {
                chart.row = row;
                if (chart.script.empty()) chart.script = chart.name;
                if (!part.charts_by.empty()) {
                    chart.name += "_" + word;
                    chart.values[part.charts_by] = quoted(word);
                }
                all.push_back(chart);
            }
        }
    }
    return all;
}

}  // namespace drape
