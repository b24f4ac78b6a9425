#include "row.h"

#include <fmt/ranges.h>

#include "drape/base/input_error.h"

namespace drape {

void Row::set(const std::string& column, const Cell& cell) {
    cells_.insert_or_assign(column, cell);
    if (const auto* quartiles = std::get_if<Quartiles>(&cell)) {
        set(column, quartiles->median);
        set(quartile_name(column, "_lower"), quartiles->lower);
        set(quartile_name(column, "_upper"), quartiles->upper);
    }
}

void Row::set(const Row& other) {
    for (const auto& [column, cell] : other.cells_) set(column, cell);
}

TableRow Row::texts(const Columns& columns, int digits) const {
    for (const auto& [name, cell] : cells_) {
        if (std::ranges::find(columns, name, &Column::name) != columns.end()) continue;
        throw RunError("a row has a cell for '" + name + "', and its table no such column");
    }
    TableRow texts;
    for (const Column& column : columns) {
        const auto found = cells_.find(column.name);
        const bool is_word = column.kind == Column::Kind::Word;
        const Cell cell = found != cells_.end() ? found->second : is_word ? Cell("none") : Cell(no_number);
        if (is_word != std::holds_alternative<std::string>(cell)) {
            throw RunError("a row's cell for '" + column.name + "' is not of the kind of its column");
        }
        texts.push_back(is_word ? std::get<std::string>(cell) : column.cell(std::get<double>(cell), digits));
    }
    return texts;
}

Rows rows_of(const Columns& columns, const std::vector<TableRow>& table) {
    Rows rows;
    for (const TableRow& texts : table) {
        Row& row = rows.emplace_back();
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const bool word = columns[k].kind == Column::Kind::Word;
            row.set(columns[k].name, word ? Cell(texts[k]) : Cell(number_in(texts[k])));
        }
    }
    return rows;
}

Rows rows_with(Rows rows, const char* column, const std::string& word) {
    std::erase_if(rows, [&](const Row& row) { return row.word(column) != word; });
    return rows;
}

std::string in_words(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

}  // namespace drape
