#pragma once

#include <limits>
#include <string>
#include <vector>

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

    /// The same column, in which "nan" may also stand: there is no such number.
    [[nodiscard]] Column or_nan() const;

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

}  // namespace drape
