#include "chart_text.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "drape/base/numbers.h"

namespace drape {

ChartTable::ChartTable(std::vector<Column> columns, const std::vector<TableRow>& rows)
    : columns_(std::move(columns)), rows_(rows) {}

bool ChartTable::has(const Picked& picked) const {
    return std::ranges::any_of(rows_, [&](const TableRow& row) {
        return std::ranges::all_of(picked.texts,
                                   [&](const auto& text) { return cell(row, text.first) == text.second; }) &&
               std::ranges::all_of(picked.numbers, [&](const auto& number) {
                   return number_in(cell(row, number.first)) == number.second;
               });
    });
}

const std::string& ChartTable::cell(const TableRow& row, const std::string& column) const {
    const auto found = std::ranges::find(columns_, column, &Column::name);
    DRAPE_ASSERT(found != columns_.end());
    return row[static_cast<std::size_t>(found - columns_.begin())];
}

void Panel::draw(const Picked& picked, const std::vector<std::string>& columns, const std::string& style) {
    if (!table_.has(picked)) return;
    std::string condition;
    const auto demand = [&condition](const std::string& text) {
        condition += (condition.empty() ? "" : " && ") + text;
    };
    for (const auto& [name, text] : picked.texts) demand("strcol(" + in_quotes(name) + ") eq " + in_quotes(text));
    for (const auto& [name, number] : picked.numbers) demand(column(name) + " == " + real_text(number));
    items_ += (items_.empty() ? "" : ", \\\n     ") + std::string("table using (") + condition + " ? " +
              columns.front() + " : NaN)";
    for (std::size_t k = 1; k < columns.size(); ++k) items_ += ":(" + columns[k] + ")";
    items_ += " with " + style;
    has_data_ = true;
}

void Panel::entry(const std::string& style, const std::string& title) {
    items_ +=
        (items_.empty() ? "" : ", \\\n     ") + std::string("keyentry with ") + style + " title " + in_quotes(title);
}

std::string Panel::plot() const { return has_data_ ? "plot " + items_ + "\n" : "set multiplot next\n"; }

std::string in_quotes(const std::string& text) {
    std::string all = "'";
    for (const char c : text) {
        if (c == '\'') all += c;
        all += c >= 0 && c < ' ' ? ' ' : c;
    }
    return all + "'";
}

std::string column(const std::string& name, const std::string& factor) {
    return "column(" + in_quotes(name) + ")" + (factor == "1" ? "" : "*" + factor);
}

std::string coloured(const std::string& colour) { return "lc rgb " + in_quotes(colour); }

std::string begin_panels(const std::string& layout, const std::string& title, const std::string& margins,
                         double key_height) {
    return "set multiplot layout " + layout + " title " + in_quotes(title) + " font ',13' margins " + margins +
           "\nset datafile missing NaN\nset grid xtics ytics lt 1 lc rgb '#e0e0e0'\nset autoscale fix\n"
           "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\nset key at screen 0.5," +
           real_text(key_height) + " center center vertical maxrows 2 samplen 2\n";
}

std::string end_panels() { return "unset multiplot\nreset\nset datafile separator ','\nset datafile columnheaders\n"; }

std::string readable(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

}  // namespace drape
