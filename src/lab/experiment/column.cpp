#include "column.h"

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

bool accepts(const Column& column, const std::string& cell) {
    return is_one_of(column.words, cell) || (column.kind != Column::Kind::Word && in_range(column, cell));
}

}  // namespace

Column Column::or_words(std::vector<std::string> others) const {
    Column more = *this;
    more.words.insert(more.words.end(), others.begin(), others.end());
    return more;
}

Column Column::with_quartiles() const {
    Column more = *this;
    more.quartiles = true;
    return more;
}

std::string Column::cell(double value, int digits) const {
    if (std::isnan(value) && is_one_of(words, "")) return "";
    return real_text(value, kind == Kind::Whole ? 17 : digits);
}

std::string Column::allowed() const {
    if (kind == Kind::Word) return listed(words);
    std::string text = kind == Kind::Whole ? "a whole number" : "a finite number";
    if (std::isfinite(least)) text += (above ? " > " : " >= ") + real_text(least);
    return words.empty() ? text : text + ", or " + listed(words);
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

std::string quartile_name(const std::string& column, const char* mark) {
    return std::string(column).insert(column.find('_'), mark);
}

Columns::Columns(std::initializer_list<Column> columns) {
    for (const Column& column : columns) {
        push_back(column);
        if (!column.quartiles) continue;
        for (const char* mark : {"_lower", "_upper"}) {
            push_back(column);
            back().name = quartile_name(column.name, mark);
        }
    }
}

std::string flaw_of(const Columns& columns, const TableRow& row) {
    DRAPE_ASSERT(row.size() == columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (accepts(columns[k], row[k])) continue;
        return "column " + columns[k].name + ": '" + shortened(row[k]) + "': allowed " + columns[k].allowed();
    }
    return "";
}

double number_in(const std::string& cell) {
    const auto number = parse_real(cell);
    DRAPE_ASSERT(cell.empty() || number.has_value());
    return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace drape
