#pragma once

#include <functional>
#include <string>
#include <vector>

#include "table_column.h"

namespace drape {

/// One line of an experiment's table, a text a column.
using TableRow = std::vector<std::string>;

/// A part of an experiment that needs no other: it computes some rows of the table, at least one.
using ExperimentCase = std::function<std::vector<TableRow>()>;

/// A picture of a table, drawn by gnuplot.
struct Chart {
    std::string name;          ///< of the files, without what follows the dot: letters, digits and '_'
    int width, height;         ///< pixels
    std::string plot;          ///< commands after the terminal is set; the table is the string variable `table`. Text
                               ///< in them is our own, a word of a column or a number that we wrote: no other cell
    std::string caption = {};  ///< one sentence or two on what it shows, under the picture
};

/// A question that is answered by a table: a list of independent cases, and charts of what they found.
struct Experiment {
    std::string name;
    std::string question;
    std::vector<Column> columns;
    std::function<std::vector<ExperimentCase>(bool quick)> cases;
    std::function<std::vector<Chart>(const std::vector<TableRow>& rows)> charts;
    std::function<std::string(const std::vector<TableRow>& rows)> summary;  ///< printed at the end
    /// What the rows of one case lack although each is good by itself; empty if nothing. Not all experiments have it.
    std::function<std::string(const std::vector<TableRow>& rows)> flaw_of_case = {};
};

/// Every experiment of the laboratory.
const std::vector<Experiment>& experiments();

}  // namespace drape
