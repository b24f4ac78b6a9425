#include "row_format.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

bool is_one_of(const std::vector<std::string>& words, const std::string& cell) {
    return std::ranges::find(words, cell) != words.end();
}

bool in_range(const Column& column, const std::string& cell) {
    constexpr double most_whole = 9007199254740992;  // 2^53: up to here a double tells all whole numbers apart
    const auto number = parse_real(cell);
    if (!number || !std::isfinite(*number)) return false;
    if (column.kind == Column::Kind::Whole && (*number != std::floor(*number) || *number > most_whole)) return false;
    return column.above ? *number > column.least : *number >= column.least;
}

/// Whether words may stand for numbers in this row.
bool may_lack_number(const std::vector<Column>& columns, const Column& column, const TableRow& row) {
    if (column.only_where.empty()) return true;
    const auto key = std::ranges::find(columns, column.only_where, &Column::name);
    DRAPE_ASSERT(key != columns.end());
    return is_one_of(column.rows_with, row[static_cast<std::size_t>(key - columns.begin())]);
}

bool accepts(const std::vector<Column>& columns, const Column& column, const TableRow& row, const std::string& cell) {
    if (column.kind == Column::Kind::Word) return is_one_of(column.words, cell);
    return in_range(column, cell) || (is_one_of(column.words, cell) && may_lack_number(columns, column, row));
}

}  // namespace

Column Column::or_words(std::vector<std::string> others) const {
    Column more = *this;
    more.words.insert(more.words.end(), others.begin(), others.end());
    return more;
}

Column Column::where(std::string column, std::vector<std::string> with) const {
    Column bound = *this;
    bound.only_where = std::move(column);
    bound.rows_with = std::move(with);
    return bound;
}

std::string Column::cell(double value, int digits) const {
    if (std::isnan(value) && is_one_of(words, "")) return "";
    return real_text(value, kind == Kind::Whole ? 17 : digits);
}

std::string Column::allowed() const {
    if (kind == Kind::Word) return listed(words);
    std::string text = kind == Kind::Whole ? "a whole number" : "a finite number";
    if (std::isfinite(least)) text += (above ? " > " : " >= ") + real_text(least);
    if (words.empty()) return text;
    text += ", or " + listed(words);
    return only_where.empty() ? text : text + " where " + only_where + " is " + listed(rows_with);
}

Column word_column(std::string name, std::vector<std::string> words) {
    return {.name = std::move(name), .words = std::move(words)};
}

Column whole_column(std::string name, double least) {
    return {.name = std::move(name), .kind = Column::Kind::Whole, .least = least};
}

Column number_column(std::string name) { return {.name = std::move(name), .kind = Column::Kind::Number, .least = 0}; }

Column positive_column(std::string name) {
    return {.name = std::move(name), .kind = Column::Kind::Number, .least = 0, .above = true};
}

std::string flaw_of(const std::vector<Column>& columns, const TableRow& row) {
    DRAPE_ASSERT(row.size() == columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (accepts(columns, columns[k], row, row[k])) continue;
        return "column " + columns[k].name + ": '" + shortened(row[k]) + "': allowed " + columns[k].allowed();
    }
    return "";
}

std::string in_words(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

double number_in(const std::string& cell) {
    const auto number = parse_real(cell);
    DRAPE_ASSERT(cell.empty() || number.has_value());
    return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace drape
