#pragma once

#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "drape/base/enum_names.h"

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
    bool quartiles = false;  ///< it is a median: NAME_lower_UNIT and NAME_upper_UNIT follow NAME_UNIT

    /// The same column, in which such words may also stand.
    [[nodiscard]] Column or_words(std::vector<std::string> others) const;

    /// The same column, in which "nan" may also stand: there is no such number. Some processors give what 0/0 is a
    /// sign.
    [[nodiscard]] Column or_nan() const { return or_words({"nan", "-nan"}); }

    /// The same column, followed by those of the quartiles.
    [[nodiscard]] Column with_quartiles() const;

    /// What stands for a number in a cell; where a word may stand for no number, it does so for nan.
    /// @param digits that are written of a number that is not a whole one
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

/// The name of a quartile's column beside that of its median: NAME_lower_UNIT.
/// @param mark "_lower" or "_upper"
std::string quartile_name(const std::string& column, const char* mark);

/// The columns of a table, those of quartiles among them.
struct Columns : std::vector<Column> {
    Columns(std::initializer_list<Column> columns);
};

/// What is wrong with the cells of a row: "column NAME: 'value': allowed ..."; empty if nothing is.
/// @param row as many cells as there are columns
std::string flaw_of(const Columns& columns, const TableRow& row);

/// The number in a cell that has been checked; nan if it is empty.
double number_in(const std::string& cell);

}  // namespace drape
