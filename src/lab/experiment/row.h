#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "drape/base/enum_names.h"
#include "lab/measure/statistics.h"

namespace drape {

struct Columns;

/// A column of a table, and what its cells may be: one of some words, or a finite number within a range. Nothing else
/// is written into a table, and nothing else is read from one. There is no column of free text.
struct Column {
    enum class Kind { Word, Whole, Number, Positive };

    std::string name;
    Kind kind = Kind::Word;
    std::vector<std::string> words = {};  ///< those allowed; in a column of numbers, what may stand in place of one
    double least = 0;                     ///< of a number; a positive one is more

    /// The same column, in which such words may also stand.
    [[nodiscard]] Column or_words(const std::vector<std::string>& others) const;

    /// The same column, in which "nan" may also stand: there is no such number. Some processors give what 0/0 is a
    /// sign.
    [[nodiscard]] Column or_nan() const { return or_words({"nan", "-nan"}); }

    /// The same column as that of a median NAME_UNIT, and those of its quartiles, NAME_lower_UNIT and NAME_upper_UNIT.
    [[nodiscard]] Columns with_quartiles() const;
};

/// The columns of a table, one after the other.
struct Columns : std::vector<Column> {
    Columns(const Column& column) { push_back(column); }
    Columns(std::initializer_list<Columns> parts) {
        for (const Columns& part : parts) insert(end(), part.begin(), part.end());
    }
};

/// A column of known words.
inline Column word_column(std::string name, std::vector<std::string> words) {
    return {.name = std::move(name), .words = std::move(words)};
}

/// A column of the names of an enumeration's values, and others.
template <Enumeration Enum>
Column name_column(std::string name, const std::vector<std::string>& others = {}) {
    const auto names = names_of<Enum>();
    return word_column(std::move(name), {names.begin(), names.end()}).or_words(others);
}

/// A column of whole numbers.
inline Column whole_column(std::string name, double least = 0) {
    return {.name = std::move(name), .kind = Column::Kind::Whole, .least = least};
}

/// A column of numbers that are not negative.
inline Column number_column(std::string name) { return {std::move(name), Column::Kind::Number}; }

/// A column of numbers above zero.
inline Column positive_column(std::string name) { return {std::move(name), Column::Kind::Positive}; }

/// One line of an experiment's table, a text a column.
using TableRow = std::vector<std::string>;

/// What is wrong with the cells of a row: "column NAME: 'value': allowed ..."; empty if nothing is.
/// @param row as many cells as there are columns
std::string flaw_of(const Columns& columns, const TableRow& row);

/// What a row has in a column: a number, a word, or a median and its quartiles, which are cells of their own.
struct Cell : std::variant<double, std::string, Quartiles> {
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) Cell(Number number)
        : variant(static_cast<double>(number)) {}
    template <Enumeration Enum>
    Cell(Enum value) : variant(name_of(value)) {}
    Cell(const char* word) : variant(word) {}
    Cell(std::string word) : variant(std::move(word)) {}
    Cell(const Quartiles& quartiles) : variant(quartiles) {}
};

/// A row of an experiment's table, by the names of its columns. What a case does not say is nan, or the word "none".
class Row {
public:
    Row() = default;
    Row(std::initializer_list<std::pair<std::string, Cell>> cells) {
        for (const auto& [column, cell] : cells) set(column, cell);
    }

    void set(const std::string& column, const Cell& cell);

    /// Sets the cells that another row has.
    void set(const Row& other);

    /// @throws std::out_of_range if the row has no cell there
    [[nodiscard]] double number(const std::string& column) const { return std::get<double>(cells_.at(column)); }
    [[nodiscard]] std::string word(const std::string& column) const { return std::get<std::string>(cells_.at(column)); }

    /// The text of its cell in a column.
    /// @param digits of a number that is not a whole one
    /// @throws RunError if it is a word for a number, or a number for a word
    [[nodiscard]] std::string text(const Column& column, int digits) const;

    /// Those of all its cells.
    /// @throws RunError also if it has a cell that no column has
    [[nodiscard]] TableRow texts(const Columns& columns, int digits) const;

private:
    std::map<std::string, Cell> cells_;
};

using Rows = std::vector<Row>;

/// Rows that have a word in a column.
Rows rows_with(Rows rows, const char* column, const std::string& word);

/// The names of some items, for a column of words.
template <class Items, class Name>
std::vector<std::string> names_in(const Items& items, Name name) {
    std::vector<std::string> names;
    for (const auto& item : items) names.emplace_back(std::invoke(name, item));
    return names;
}

/// The words that rows have in a column, each once, in the order in which they come.
std::vector<std::string> words_of(const Rows& rows, const char* column);

}  // namespace drape
