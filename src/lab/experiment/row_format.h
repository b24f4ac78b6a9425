#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "table_column.h"

namespace drape {

/// A column of a table, and the member of a row that stands in it.
template <class Row>
struct Field {
    Column column;
    std::variant<double Row::*, std::string Row::*> member;
};

/// How the rows of an experiment stand in its table: one list of fields makes columns, cells and rows.
template <class Row>
class RowFormat {
public:
    /// @param digits that are written of a number that is not a whole one
    RowFormat(int digits, std::vector<Field<Row>> fields) : digits_(digits), fields_(std::move(fields)) {}

    [[nodiscard]] std::vector<Column> columns() const {
        std::vector<Column> all;
        for (const Field<Row>& field : fields_) all.push_back(field.column);
        return all;
    }

    [[nodiscard]] TableRow cells(const Row& row) const {
        TableRow cells;
        for (const auto& [column, member] : fields_) {
            cells.push_back(std::visit([&](auto place) { return column.cell(row.*place, digits_); }, member));
        }
        return cells;
    }

    /// @param cells as many as there are fields, checked by the columns
    [[nodiscard]] Row row(const TableRow& cells) const {
        Row row;
        for (std::size_t k = 0; k < fields_.size(); ++k) {
            std::visit([&](auto place) { read(cells[k], row.*place); }, fields_[k].member);
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

/// The words that rows have in a member, each once, in the order in which they come.
template <class Row>
std::vector<std::string> words_of(const std::vector<Row>& rows, std::string Row::*member) {
    std::vector<std::string> words;
    for (const Row& row : rows) {
        if (std::ranges::find(words, row.*member) == words.end()) words.push_back(row.*member);
    }
    return words;
}

/// Rows that have a word in a member.
template <class Row>
std::vector<Row> rows_with(std::vector<Row> rows, std::string Row::*member, const std::string& word) {
    std::erase_if(rows, [&](const Row& row) { return row.*member != word; });
    return rows;
}

}  // namespace drape
