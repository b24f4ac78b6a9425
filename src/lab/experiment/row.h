#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "column.h"
#include "lab/measure/statistics.h"

namespace drape {

/// What a row has in a column: a number, a word, or a median and its quartiles, which are cells of their own.
struct Cell : std::variant<double, std::string, Quartiles> {
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) Cell(Number number)
        : variant(static_cast<double>(number)) {}
    template <NamedEnum Enum>
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

    /// The texts of its cells.
    /// @param digits of a number that is not a whole one
    /// @throws RunError if it has a cell that no column has, or a word for a number
    [[nodiscard]] TableRow texts(const Columns& columns, int digits) const;

private:
    std::map<std::string, Cell> cells_;
};

using Rows = std::vector<Row>;

/// The rows of a checked table.
Rows rows_of(const Columns& columns, const std::vector<TableRow>& table);

// What rows are sorted, grouped and told by.

/// The number in a column of a row.
inline auto number_of(const char* column) {
    return [column](const Row& row) { return row.number(column); };
}

/// The word in a column of a row.
inline auto word_of(const char* column) {
    return [column](const Row& row) { return row.word(column); };
}

/// Rows that have a word in a column.
Rows rows_with(Rows rows, const char* column, const std::string& word);

/// The names of some items, for a column of words.
template <class Items, class Name>
std::vector<std::string> names_in(const Items& items, Name name) {
    std::vector<std::string> names;
    for (const auto& item : items) names.emplace_back(std::invoke(name, item));
    return names;
}

/// The words that a function has for rows, each once, in the order in which they come.
template <class Item, class Word>
std::vector<std::string> words_of(const std::vector<Item>& rows, Word word) {
    std::vector<std::string> words;
    for (const std::string& one : names_in(rows, word)) {
        if (std::ranges::find(words, one) == words.end()) words.push_back(one);
    }
    return words;
}

/// The words that rows have in a column.
inline std::vector<std::string> words_of(const Rows& rows, const char* column) {
    return words_of(rows, word_of(column));
}

/// Rows by what a function has for them.
template <class Item, class Key>
auto groups_of(const std::vector<Item>& rows, Key key) {
    std::map<std::decay_t<std::invoke_result_t<Key, const Item&>>, std::vector<Item>> groups;
    for (const Item& row : rows) groups[std::invoke(key, row)].push_back(row);
    return groups;
}

/// A list of words for the script of a chart: "drop curtain".
std::string in_words(const std::vector<std::string>& words);

}  // namespace drape
