#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "row_format.h"

namespace drape {

/// A picture of a table, drawn by gnuplot from an installed script.
struct Chart {
    /// A number, or words. No other text becomes part of a gnuplot program.
    using Value = std::variant<double, std::string>;

    std::string name;                     ///< of the files, without what follows the dot: letters, digits and '_'
    std::string script;                   ///< charts/SCRIPT.gp
    std::string caption;                  ///< one sentence or two on what it shows, under the picture
    std::map<std::string, Value> values;  ///< variables of the script; `table` and `name` are always there
    std::string data = {};                ///< what more it reads, from the file in the variable `data`
};

/// A part of an experiment that needs no other: it computes some rows of the table, at least one.
template <class Row>
using CaseOf = std::function<std::vector<Row>()>;
using ExperimentCase = CaseOf<TableRow>;

/// A question that is answered by a table: a list of independent cases, and charts of what they found.
struct Experiment {
    std::string name;
    std::string question;
    std::vector<Column> columns;
    std::function<std::vector<ExperimentCase>(bool quick)> cases;
    std::function<std::vector<Chart>(const std::vector<TableRow>& rows)> charts;
    std::function<std::string(const std::vector<TableRow>& rows)> summary;  ///< printed at the end
    /// What the rows of one case lack although each is good by itself; empty if nothing.
    std::function<std::string(const std::vector<TableRow>& rows)> flaw_of_case;
};

/// The same as an experiment writes it: with rows of its own.
template <class Row>
struct ExperimentOf {
    std::string name;
    std::string question;
    RowFormat<Row> format;
    std::function<std::vector<CaseOf<Row>>(bool quick)> cases;
    std::function<std::vector<Chart>(const std::vector<Row>& rows)> charts;
    std::function<std::string(const std::vector<Row>& rows)> summary;
    std::function<std::string(const std::vector<Row>& rows)> flaw_of_case = [](const auto&) { return ""; };

    /// Its rows become cells where they leave a case, and rows again where a checked table is shown.
    [[nodiscard]] Experiment as_table() const {
        const auto read = [rows = format](const auto& show) {
            // A share may have no cases
            return [rows, show](const std::vector<TableRow>& cells) {
                const auto typed = rows.rows(cells);
                return typed.empty() ? decltype(show(typed)){} : show(typed);
            };
        };
        const auto written = [rows = format, make = cases](bool quick) {
            std::vector<ExperimentCase> all;
            for (auto& one : make(quick)) all.push_back([rows, one] { return rows.cells(one()); });
            return all;
        };
        return {name, question, format.columns(), written, read(charts), read(summary), read(flaw_of_case)};
    }
};

}  // namespace drape
