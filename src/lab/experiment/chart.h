#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

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

/// A list of words for a script: "drop curtain".
std::string in_words(const std::vector<std::string>& words);

/// The values of a chart as gnuplot commands: plain variables, finite numbers, and texts of letters, digits and
/// " _:.+-" in single quotes.
/// @throws RunError if there is any other
std::string assignments_of(const Chart& chart);

/// Draws charts of a table as SVG and PNG beside it, each by NAME.gnuplot, which stays there for who wants to change
/// it: the values, and the installed script below them.
/// @return false if there is no gnuplot
/// @throws RunError if a file cannot be read or written, or gnuplot fails
bool draw_charts(const std::vector<Chart>& charts, const std::filesystem::path& table);

}  // namespace drape
