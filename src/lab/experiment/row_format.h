#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/base/enum_names.h"
#include "lab/measure/statistics.h"

namespace drape {

/// One line of an experiment's table, a text a column.
using TableRow = std::vector<std::string>;

/// A column of a table, and what its cells may be: one of some words, or a finite number within a range. Nothing else
/// is written into a table, and nothing else is read from one. There is no column of free text.
struct Column {
    enum class Kind { Word, Whole, Number };

    std::string name;
    Kind kind = Kind::Word;
    std::vector<std::string> words = {};  ///< those allowed; in a column of numbers, what may stand in place of one
    double least = -std::numeric_limits<double>::infinity();  ///< of a number
    bool above = false;                                       ///< a number must be more than `least`

    /// The same column, in which such words may also stand.
    [[nodiscard]] Column or_words(std::vector<std::string> others) const;

    /// The same column, in which "nan" may also stand: there is no such number. Some processors give what 0/0 is a
    /// sign.
    [[nodiscard]] Column or_nan() const { return or_words({"nan", "-nan"}); }

    /// What stands for a number in a cell; where a word may stand for no number, it does so for nan.
    [[nodiscard]] std::string cell(double value, int digits) const;

    /// What a cell may be, as a message says it.
    [[nodiscard]] std::string allowed() const;
};

/// A column of known words.
Column word_column(std::string name, std::vector<std::string> words);

/// A column of the names of an enumeration's values, and others.
template <NamedEnum Enum>
Column name_column(std::string name, const std::vector<std::string>& others = {}) {
    const auto names = names_of<Enum>();
    return word_column(std::move(name), {names.begin(), names.end()}).or_words(others);
}

/// A column of whole numbers.
Column whole_column(std::string name, double least = 0);

/// A column of numbers that are not negative.
Column number_column(std::string name);

/// A column of numbers above zero.
Column positive_column(std::string name);

/// What is wrong with the cells of a row: "column NAME: 'value': allowed ..."; empty if nothing is.
/// @param row as many cells as there are columns
std::string flaw_of(const std::vector<Column>& columns, const TableRow& row);

/// The number in a cell that has been checked; nan if it is empty.
double number_in(const std::string& cell);

/// The cell of a value: a number, a word, one of an enumeration's values by its name, or the first or second word of
/// its column for no or yes.
template <class Value>
std::string cell_of(const Column& column, const Value& value, int digits) {
    if constexpr (std::is_same_v<Value, std::string>) return value;
    if constexpr (NamedEnum<Value>) return name_of(value);
    if constexpr (std::is_same_v<Value, bool>) return column.words[value ? 1 : 0];
    if constexpr (std::is_arithmetic_v<Value>) return column.cell(static_cast<double>(value), digits);
}

/// Reads what `cell_of` has written.
template <class Value>
void read_cell(const Column& column, const std::string& cell, Value& value) {
    static_assert(!std::is_integral_v<Value> || std::is_same_v<Value, bool> || sizeof(Value) == 8,
                  "any whole number of a table fits");
    if constexpr (std::is_same_v<Value, std::string>) value = cell;
    if constexpr (NamedEnum<Value>) value = value_named<Value>(cell).value();
    if constexpr (std::is_same_v<Value, bool>) {
        value = cell != column.words[0];
    } else if constexpr (std::is_arithmetic_v<Value>) {
        value = static_cast<Value>(number_in(cell));
    }
}

/// A member of a row, and the columns in which it stands: one, or three of quartiles, NAME_UNIT for the median,
/// NAME_lower_UNIT and NAME_upper_UNIT, unless the field names one of them.
template <class Row>
struct Field {
    struct Cell {
        Column column;
        std::function<std::string(const Row& row, int digits)> write;
        std::function<void(Row& row, const std::string& cell)> read;
    };

    template <class Owner, class Value>
    Field(const Column& column, Value Owner::*member) {
        const auto place = [member](auto& row) -> auto& { return row.*member; };
        add(column, place);
    }

    /// A part of a member that has several.
    template <class Owner, class Member, class Value>
    Field(const Column& column, Member Owner::*member, Value Member::*part) {
        const auto place = [=](auto& row) -> auto& { return (row.*member).*part; };
        add(column, place);
    }

    template <class Owner>
    Field(Column column, Quartiles Owner::*member) : Field(column, member, &Quartiles::median) {
        const std::string name = column.name;
        for (const auto& [mark, quartile] :
             {std::pair("_lower", &Quartiles::lower), std::pair("_upper", &Quartiles::upper)}) {
            column.name = std::string(name).insert(name.find('_'), mark);
            cells.push_back(Field(column, member, quartile).cells.front());
        }
    }

    template <class Place>
    void add(const Column& column, const Place& place) {
        cells.push_back({column, [=](const Row& row, int digits) { return cell_of(column, place(row), digits); },
                         [=](Row& row, const std::string& cell) { read_cell(column, cell, place(row)); }});
    }

    std::vector<Cell> cells = {};
};

/// How the rows of an experiment stand in its table: one list of fields makes columns, cells and rows.
template <class Row>
class RowFormat {
public:
    /// @param digits that are written of a number that is not a whole one
    RowFormat(int digits, const std::vector<Field<Row>>& fields) : digits_(digits) {
        for (const auto& [cells] : fields) std::ranges::copy(cells, std::back_inserter(cells_));
    }

    [[nodiscard]] std::vector<Column> columns() const {
        std::vector<Column> all;
        for (const auto& cell : cells_) all.push_back(cell.column);
        return all;
    }

    [[nodiscard]] TableRow cells(const Row& row) const {
        TableRow cells;
        for (const auto& cell : cells_) cells.push_back(cell.write(row, digits_));
        return cells;
    }

    /// @param cells as many as there are columns, checked by them
    [[nodiscard]] Row row(const TableRow& cells) const {
        Row row;
        for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k].read(row, cells[k]);
        return row;
    }

    [[nodiscard]] std::vector<TableRow> cells(const std::vector<Row>& rows) const {
        std::vector<TableRow> all;
        for (const Row& one : rows) all.push_back(cells(one));
        return all;
    }

    [[nodiscard]] std::vector<Row> rows(const std::vector<TableRow>& table) const {
        std::vector<Row> all;
        for (const TableRow& cells : table) all.push_back(row(cells));
        return all;
    }

private:
    int digits_;
    std::vector<typename Field<Row>::Cell> cells_;
};

/// The names of some items, for a column of words.
template <class Items, class Name>
std::vector<std::string> names_in(const Items& items, Name name) {
    std::vector<std::string> names;
    for (const auto& item : items) names.emplace_back(std::invoke(name, item));
    return names;
}

/// The words that rows have in a member, or that a function has for them, each once, in the order in which they come.
template <class Row, class Word>
std::vector<std::string> words_of(const std::vector<Row>& rows, Word word) {
    std::vector<std::string> words;
    for (const std::string& one : names_in(rows, word)) {
        if (std::ranges::find(words, one) == words.end()) words.push_back(one);
    }
    return words;
}

/// Rows by what a function has for them.
template <class Row, class Key>
auto groups_of(const std::vector<Row>& rows, Key key) {
    std::map<std::decay_t<std::invoke_result_t<Key, const Row&>>, std::vector<Row>> groups;
    for (const Row& row : rows) groups[std::invoke(key, row)].push_back(row);
    return groups;
}

/// A list of words for the script of a chart: "drop curtain".
std::string in_words(const std::vector<std::string>& words);

/// Rows that have a word in a member.
template <class Row, class Owner>
std::vector<Row> rows_with(std::vector<Row> rows, std::string Owner::*member, const std::string& word) {
    std::erase_if(rows, [&](const Row& row) { return row.*member != word; });
    return rows;
}

}  // namespace drape
