#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiment.h"

namespace drape {

// Pieces of gnuplot commands for charts of several panels that read a table by the names of its columns.

/// Rows that are picked by what stands in some of their columns.
struct Picked {
    std::vector<std::pair<std::string, std::string>> texts;  ///< column and text
    std::vector<std::pair<std::string, double>> numbers;     ///< column and number
};

/// A table of which parts may be missing: what has no rows is not drawn.
class ChartTable {
public:
    /// @param rows checked by the columns; they outlive the object, as does nothing else
    ChartTable(std::vector<Column> columns, const std::vector<TableRow>& rows);

    [[nodiscard]] bool has(const Picked& picked) const;

private:
    [[nodiscard]] const std::string& cell(const TableRow& row, const std::string& column) const;

    std::vector<Column> columns_;
    const std::vector<TableRow>& rows_;
};

/// One panel of a chart.
class Panel {
public:
    explicit Panel(const ChartTable& table) : table_(table) {}

    /// Adds rows, if there are any.
    /// @param columns expressions: x and y, and what else the style reads
    /// @param style as after "with"
    void draw(const Picked& picked, const std::vector<std::string>& columns, const std::string& style);

    /// Adds an entry of the legend without data.
    void entry(const std::string& style, const std::string& title);

    /// The command that draws it, or leaves its place free if there is nothing to draw.
    [[nodiscard]] std::string plot() const;

private:
    const ChartTable& table_;
    std::string items_;
    bool has_data_ = false;
};

/// A text as gnuplot reads it back: in single quotes, between which it replaces nothing and runs nothing. A
/// control character becomes a blank: a line end would be the end of the command.
std::string in_quotes(const std::string& text);

/// The value of a column, times a factor.
std::string column(const std::string& name, const std::string& factor = "1");

/// A colour of a line or point, as in "#0072B2".
std::string coloured(const std::string& colour);

/// Starts a chart of panels: its title, a light grid, and a legend below all of them.
/// @param layout "rows,columns"
/// @param margins "left,right,bottom,top spacing x,y", parts of the picture
/// @param key_height of the middle of the legend, a part of the picture
std::string begin_panels(const std::string& layout, const std::string& title, const std::string& margins,
                         double key_height);

/// Ends it, so that the next terminal can draw it again.
std::string end_panels();

/// A name as it is read: with blanks.
std::string readable(std::string name);

}  // namespace drape
