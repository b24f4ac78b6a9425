#pragma once

#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "row.h"

namespace drape {

/// A picture of a table, drawn by gnuplot from an installed script.
struct Chart {
    /// A number, or words. No other text becomes part of a gnuplot program.
    using Value = std::variant<double, std::string>;

    std::string name;                          ///< of the files, without what follows the dot: letters, digits and '_'
    std::map<std::string, Value> values = {};  ///< variables of the script; `table` and `name` are always there
    std::string script = {};                   ///< charts/SCRIPT.gp; empty: that of the chart's name
    std::string caption = {};                  ///< under the picture, after what the script's head says of it
};

/// The values of a chart as gnuplot commands: plain variables, finite numbers, and texts of letters, digits and
/// " _:.+-" in single quotes.
/// @throws RunError if there is any other
std::string assignments_of(const Chart& chart);

/// What is drawn of some rows of a table.
using ChartsOfRows = std::function<std::vector<Chart>(const Rows& rows)>;

/// Some charts, whatever the rows are. A script that finds nothing to draw makes no picture.
inline ChartsOfRows charts_of(std::vector<Chart> charts) {
    return [charts = std::move(charts)](const Rows&) { return charts; };
}

/// A chart SCRIPT_WORD for each word that rows have in a column, which is the script's variable of that name.
ChartsOfRows charts_by(const char* column, const char* script);

/// A part of an experiment that needs no other: it computes some rows of the table, at least one.
using ExperimentCase = std::function<Rows()>;
using ExperimentCases = std::vector<ExperimentCase>;

/// Some cases, and what is drawn of their rows where there are any. A share may have none.
struct ExperimentPart {
    /// Written to column `part` of its rows; empty if it is the only part and there is no such column.
    std::string name;
    std::function<ExperimentCases(bool quick)> cases;
    ChartsOfRows charts;  ///< {}: none
};

/// What is printed of a table at its end, by the names of columns: a line for each choice of cells in some of them,
/// with the range of the numbers that its rows have in others.
struct Summary {
    std::vector<std::string> by, of;
};

/// A question that is answered by a table: a list of independent cases, and charts of what they found.
struct Experiment {
    std::string name;
    std::string question;
    int digits;  ///< that the table has of a number that is not a whole one
    Columns columns;
    Summary summary;
    std::vector<ExperimentPart> parts;

    /// Those of all parts.
    [[nodiscard]] ExperimentCases cases(bool quick) const;

    /// Those of all parts.
    /// @param rows with a cell in every column
    [[nodiscard]] std::vector<Chart> charts(const Rows& rows) const;
};

/// "rk4, damping, agrees: 28 rows, measured_step_s 0.0012 to 0.0031", line by line, in the order in which they come.
/// Numbers that there are not are left out.
/// @param rows with a cell in every column
std::string summary_of(const Experiment& experiment, const Rows& rows);

/// A case for each choice of one value from every list; those of the last list change fastest.
/// @param run(values...) gives the rows
inline ExperimentCases cases_over(const ExperimentCase& run) { return {run}; }

template <class Run, class Value, class... Values>
ExperimentCases cases_over(const Run& run, const std::vector<Value>& list, const std::vector<Values>&... lists) {
    ExperimentCases all;
    for (const Value& value : list) {
        const auto chosen = [=](const Values&... others) { return run(value, others...); };
        std::ranges::move(cases_over(chosen, lists...), std::back_inserter(all));
    }
    return all;
}

}  // namespace drape
