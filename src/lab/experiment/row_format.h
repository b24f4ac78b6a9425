#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <variant>
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

    /// Where not empty: words in place of a number may stand only in rows that have one of `rows_with` in this column.
    std::string only_where = {};
    std::vector<std::string> rows_with = {};

    /// The same column, in which such words may also stand.
    [[nodiscard]] Column or_words(std::vector<std::string> others) const;

    /// The same column, in which "nan" may also stand: there is no such number. Some processors give what 0/0 is a
    /// sign.
    [[nodiscard]] Column or_nan() const { return or_words({"nan", "-nan"}); }

    /// The same column, in which a word may stand for a number only in some rows.
    /// @param column a column of words
    /// @param with what it has in those rows
    [[nodiscard]] Column where(std::string column, std::vector<std::string> with) const;

    /// What stands for a value in a cell; where a word may stand for no number, it does so for nan.
    [[nodiscard]] std::string cell(double value, int digits) const;
    [[nodiscard]] static std::string cell(const std::string& word, int /*digits*/) { return word; }

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

/// A column of a table, and the member of a row that stands in it. Quartiles take three columns, NAME_UNIT for the
/// median, NAME_lower_UNIT and NAME_upper_UNIT, unless the field names one of them.
template <class Row>
struct Field {
    Column column;
    std::variant<double Row::*, std::string Row::*, Quartiles Row::*> member;
    double Quartiles::*quartile = nullptr;

    /// What `use` makes of the number or the word in a row.
    template <class AnyRow, class Use>
    auto visit(AnyRow& row, const Use& use) const {
        return std::visit(
            [&](auto in_row) {
                if constexpr (std::is_same_v<decltype(in_row), Quartiles Row::*>) return use((row.*in_row).*quartile);
                if constexpr (!std::is_same_v<decltype(in_row), Quartiles Row::*>) return use(row.*in_row);
            },
            member);
    }
};

/// How the rows of an experiment stand in its table: one list of fields makes columns, cells and rows.
template <class Row>
class RowFormat {
public:
    /// @param digits that are written of a number that is not a whole one
    RowFormat(int digits, const std::vector<Field<Row>>& fields) : digits_(digits) {
        for (Field<Row> field : fields) {
            const bool three = std::holds_alternative<Quartiles Row::*>(field.member) && field.quartile == nullptr;
            if (three) field.quartile = &Quartiles::median;
            fields_.push_back(field);
            const std::string name = field.column.name;
            for (const char* mark : {"_lower", "_upper"}) {
                if (!three) break;
                field.column.name = std::string(name).insert(name.find('_'), mark);
                field.quartile = mark == std::string("_lower") ? &Quartiles::lower : &Quartiles::upper;
                fields_.push_back(field);
            }
        }
    }

    [[nodiscard]] std::vector<Column> columns() const {
        std::vector<Column> all;
        for (const Field<Row>& field : fields_) all.push_back(field.column);
        return all;
    }

    [[nodiscard]] TableRow cells(const Row& row) const {
        TableRow cells;
        for (const Field<Row>& field : fields_) {
            cells.push_back(field.visit(row, [&](const auto& value) { return field.column.cell(value, digits_); }));
        }
        return cells;
    }

    /// @param cells as many as there are columns, checked by them
    [[nodiscard]] Row row(const TableRow& cells) const {
        Row row;
        for (std::size_t k = 0; k < fields_.size(); ++k) {
            fields_[k].visit(row, [&](auto& value) { read(cells[k], value); });
        }
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
    static void read(const std::string& cell, std::string& text) { text = cell; }
    static void read(const std::string& cell, double& number) { number = number_in(cell); }

    int digits_;
    std::vector<Field<Row>> fields_;
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

/// A list of words for the script of a chart: "drop curtain".
std::string in_words(const std::vector<std::string>& words);

/// Rows that have a word in a member.
template <class Row>
std::vector<Row> rows_with(std::vector<Row> rows, std::string Row::*member, const std::string& word) {
    std::erase_if(rows, [&](const Row& row) { return row.*member != word; });
    return rows;
}

}  // namespace drape
