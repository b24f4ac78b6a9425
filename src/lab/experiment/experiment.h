#pragma once

#include <functional>
#include <string>
#include <vector>

namespace drape {

/// One line of an experiment's table, a text a column.
using TableRow = std::vector<std::string>;

/// A part of an experiment that needs no other: it computes some rows of the table.
using ExperimentCase = std::function<std::vector<TableRow>()>;

/// A picture of a table, drawn by gnuplot.
struct Chart {
    std::string name;          ///< of the files, without what follows the dot
    int width, height;         ///< pixels
    std::string plot;          ///< commands after the terminal is set; the table is the string variable `table`
    std::string caption = {};  ///< one sentence or two on what it shows, under the picture
};

/// A question that is answered by a table: a list of independent cases, and charts of what they found.
struct Experiment {
    std::string name;
    std::string question;
    std::vector<std::string> columns;
    std::function<std::vector<ExperimentCase>(bool quick)> cases;
    std::function<std::vector<Chart>(const std::vector<TableRow>& rows)> charts;
    std::function<std::string(const std::vector<TableRow>& rows)> summary;  ///< printed at the end
};

/// Every experiment of the laboratory.
const std::vector<Experiment>& experiments();

}  // namespace drape
