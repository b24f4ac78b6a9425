#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/base/numbers.h"
#include "lab/measure/statistics.h"

namespace drape {

/// A column of a table, and what stands in it where a row says nothing.
struct Column {
    std::string name;
    std::string if_none = "nan";
};

/// The columns of a table, one after the other.
struct Columns : std::vector<Column> {
    Columns(const char* name) { push_back({name}); }
    Columns(const Column& column) { push_back(column); }
    Columns(std::initializer_list<Columns> parts) {
        for (const Columns& part : parts) insert(end(), part.begin(), part.end());
    }
};

/// The column of a median, NAME_UNIT, and those of its quartiles, NAME_lower_UNIT and NAME_upper_UNIT.
Columns quartile_columns(const char* median);

/// What has a name: a method, a scene.
template <class Thing>
concept Named = requires(const Thing& thing) {
    std::string(thing.name);
};

/// What a row has in a column: a word, the name of a thing, all digits of a number, or a median and its quartiles,
/// which are cells of their own.
struct Cell : std::variant<std::string, Quartiles> {
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) Cell(Number number)
        : variant(std::is_integral_v<Number> ? std::to_string(number) : real_text(static_cast<double>(number))) {}
    template <Enumeration Enum>
    Cell(Enum value) : variant(name_of(value)) {}
    template <Named Thing>
    Cell(const Thing& thing) : variant(thing.name) {}
    Cell(const char* word) : variant(word) {}
    Cell(std::string word) : variant(std::move(word)) {}
    Cell(const Quartiles& quartiles) : variant(quartiles) {}
};

/// A row of an experiment's table, by the names of its columns.
class Row {
public:
    Row() = default;
    Row(std::initializer_list<std::pair<std::string, Cell>> cells) {
        for (const auto& [column, cell] : cells) set(column, cell);
    }

    void set(const std::string& column, const Cell& cell);

    /// Sets the cells that another row has.
    void set(const Row& other);

    [[nodiscard]] bool has(const std::string& column) const { return cells_.contains(column); }

    /// What it has in a column, as a number and as it is.
    /// @throws std::out_of_range if the row has no cell there; InputError if it has a word where a number is asked for
    [[nodiscard]] double number(const std::string& column) const;
    [[nodiscard]] std::string word(const std::string& column) const { return cells_.at(column); }

    /// What a table has of it, a text a column.
    /// @param digits of a number that is not a whole one
    /// @throws RunError if it has a cell that no column has
    [[nodiscard]] std::vector<std::string> texts(const Columns& columns, int digits) const;

private:
    std::map<std::string, std::string> cells_;
};

using Rows = std::vector<Row>;

/// A picture of a table, drawn by gnuplot from an installed script.
struct Chart {
    std::string name;  ///< of the files, without what follows the dot: letters, digits and '_'
    std::map<std::string, std::string> values = {};  ///< variables of the script; `table` and `name` are always there
    std::string script = {};                         ///< charts/SCRIPT.gp; empty: that of the chart's name
    Row row = {};                                    ///< the first that it is drawn of: captions name cells of it
};

/// Words as a value of a chart. What a table was read with is none but such.
inline std::string quoted(const std::string& words) { return "'" + words + "'"; }

/// A part of an experiment that needs no other: it computes some rows of the table, at least one.
using ExperimentCase = std::function<Rows()>;
using ExperimentCases = std::vector<ExperimentCase>;
using PartCases = std::function<ExperimentCases(bool quick)>;

/// Some cases, and what is drawn of their rows where there are any. A share may have none, and a script that finds
/// nothing to draw makes no picture.
struct ExperimentPart {
    /// Written to column `part` of its rows; empty if it is the only part and there is no such column.
    std::string name;
    PartCases cases;
    std::vector<Chart> charts;
    /// Each chart is drawn as NAME_WORD for each word that rows have in this column, which is the script's variable of
    /// that name; empty: once.
    std::string charts_by = {};
};

/// A question that is answered by a table: a list of independent cases, and charts of what they found.
struct Experiment {
    std::string name;
    std::string question;
    int digits;  ///< that the table has of a number that is not a whole one
    Columns columns;
    std::vector<ExperimentPart> parts;

    /// Those of all parts.
    [[nodiscard]] ExperimentCases cases(bool quick) const;

    /// Those of all parts that have rows, each with its script.
    /// @param rows with a cell in every column
    [[nodiscard]] std::vector<Chart> charts(const Rows& rows) const;
};

/// Values that the cases of a part go through, of which a quick run may have others.
template <class Value>
struct Axis {
    std::string column;  ///< of the value, in all rows of its cases; empty: none
    std::vector<Value> quick, whole = quick;
};

/// Steps that divide a second, by how many of them make one.
inline Axis<double> steps_a_second(std::vector<double> quick, std::vector<double> whole) {
    for (double& step : quick) step = 1 / step;
    for (double& step : whole) step = 1 / step;
    return {"step_s", quick, whole};
}

/// What a run is told by its size.
template <class Value>
Axis<Value> quick_or_whole(const Value& quick, const Value& whole) {
    return {"", {quick}, {whole}};
}

/// A case whose rows also have a value in a column, if that has a name.
template <class Value>
ExperimentCase with_column(const ExperimentCase& run, const std::string& column, const Value& value) {
    return [=] {
        Rows rows = run();
        if constexpr (std::is_constructible_v<Cell, Value>) {
            for (Row& row : rows) {
                if (!column.empty()) row.set(column, value);
            }
        }
        return rows;
    };
}

inline PartCases cases_over(const ExperimentCase& measure) {
    return [=](bool) { return ExperimentCases{measure}; };
}

/// A case for each choice of one value from every axis; those of the last change fastest.
/// @param measure(values...) gives the rows, without the columns of the axes
template <class Measure, class Value, class... Values>
PartCases cases_over(Measure measure, const Axis<Value>& axis, const Axis<Values>&... others) {
    return [=](bool quick) {
        ExperimentCases all;
        for (const Value& value : quick ? axis.quick : axis.whole) {
            const auto chosen = [=](const Values&... rest) { return measure(value, rest...); };
            for (const ExperimentCase& run : cases_over(chosen, others...)(quick)) {
                all.push_back(with_column(run, axis.column, value));
            }
        }
        return all;
    };
}

}  // namespace drape
