#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "case_selection.h"
#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "experiment_table.h"

namespace drape {
namespace {

constexpr std::size_t longest_table_line = 16 * 1024;    // bytes: a line of a merged head names every machine
constexpr std::size_t largest_table = 32 * 1024 * 1024;  // bytes: the largest of a whole run has 5 million
constexpr long long most_cases = 100'000;

std::string shown(const std::string& text) { return std::string(1, '\'').append(text, 0, 100) + "'"; }

/// Reads line after line and tells where it is.
class LineReader {
public:
    LineReader(std::istream& in, std::string name, bool unfinished)
        : in_(in), name_(std::move(name)), unfinished_(unfinished) {}

    /// False at the end, or where an unfinished table is cut off.
    bool next() {
        const LineEnd end = read_line(in_, line_, longest_table_line);
        if (end == LineEnd::None) return false;
        ++number_;
        bytes_ += line_.size() + 1;
        if (bytes_ > largest_table) fail("a table has at most {} bytes", largest_table);
        if (end == LineEnd::CutOff && unfinished_) return false;
        if (end == LineEnd::CutOff) fail("cut off");
        if (end == LineEnd::TooLong) fail("too long: allowed {} bytes in a line", longest_table_line);
        const auto foreign = std::ranges::find_if(line_, [](char c) { return c < ' ' || c > '~'; });
        if (foreign != line_.end()) fail("byte {} is no printable ASCII character", foreign - line_.begin() + 1);
        return true;
    }

    [[nodiscard]] const std::string& line() const { return line_; }
    [[nodiscard]] bool at_end() { return in_.peek() == std::istream::traits_type::eof(); }

    template <class... Values>
    [[noreturn]] void fail(fmt::format_string<Values...> what, Values&&... values) const {
        throw InputError(fmt::format("{}:{}: ", name_, number_) + fmt::format(what, std::forward<Values>(values)...));
    }

private:
    std::istream& in_;
    std::string name_, line_;
    bool unfinished_;
    int number_ = 0;
    std::size_t bytes_ = 0;
};

/// The names of the head's lines, each of which is there once.
const std::array<std::string, 8> head_names{"experiment", "drape", "commit",   "machine",
                                            "compiler",   "date",  "settings", "cases"};

/// What is wrong with a line of the head; empty if nothing is.
std::string flaw_of_line(const Experiment& experiment, const std::string& name, const std::string& value) {
    const auto unless = [&](bool good, const std::string& allowed) {
        return good ? "" : name + " = " + shown(value) + ": allowed " + allowed;
    };
    if (name == "experiment") return unless(value == experiment.name, "'" + experiment.name + "'");
    if (name == "cases") {
        const auto count = parse_integer(value);
        return unless(count && *count >= 1 && *count <= most_cases, "1 to " + std::to_string(most_cases));
    }
    if (name == "settings") {
        return unless(parse_selection(value).has_value(),
                      "'whole' or '--quick', then ' --cases FIRST-LAST' and ' --share K/N' or nothing");
    }
    return "";
}

/// Reads the head and the line that names the columns.
/// @return false where it is cut off before that line ends
bool read_head(const Experiment& experiment, LineReader& reader, TableHead& head) {
    bool more = reader.next();
    for (; more && reader.line().starts_with("# "); more = reader.next()) {
        const std::string& line = reader.line();
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) reader.fail("allowed '# name: value' before the table");
        const std::string name = line.substr(2, colon - 2), value = line.substr(colon + 2);
        if (std::ranges::find(head_names, name) == head_names.end()) {
            reader.fail("head line {}: allowed {}", shown(name), listed(head_names));
        }
        if (std::ranges::any_of(head, [&](const auto& there) { return there.first == name; })) {
            reader.fail("{} is there twice", name);
        }
        if (const std::string flaw = flaw_of_line(experiment, name, value); !flaw.empty()) reader.fail("{}", flaw);
        head.emplace_back(name, value);
    }
    if (!more) return false;
    if (reader.line() != columns_line(experiment)) {
        reader.fail("these are not the columns of {}", experiment.name);
    }
    for (const std::string& name : head_names) {
        if (std::ranges::none_of(head, [&](const auto& there) { return there.first == name; })) {
            reader.fail("'# {}: ' is missing above the columns", name);
        }
    }
    return true;
}

/// The cases that a table with this head has when it is finished.
std::vector<std::size_t> cases_of(const TableHead& head, const LineReader& reader) try {
    return parse_selection(line_of(head, "settings"))
        ->numbers(static_cast<std::size_t>(*parse_integer(line_of(head, "cases"))));
} catch (const InputError& error) {
    reader.fail("the settings above have {}", error.what());
}

/// Reads the rows below the head, case after case.
class RowReader {
public:
    RowReader(const Experiment& experiment, LineReader& reader, ExperimentTable& table)
        : experiment_(experiment), reader_(reader), table_(table), wanted_(cases_of(table.head, reader)) {}

    void add() {
        const auto cells = split_at_commas(reader_.line());
        TableRow row(cells.begin(), cells.end());
        if (row.size() != experiment_.columns.size() + 1) {
            reader_.fail("{} cells: allowed {}", row.size(), experiment_.columns.size() + 1);
        }
        const auto number = parse_integer(row.front());
        const auto is = [&number](std::size_t other) { return number == static_cast<long long>(other); };
        const bool next = begun_ < wanted_.size() && is(wanted_[begun_]);
        if (!next && !(begun_ > 0 && is(wanted_[begun_ - 1]))) {
            reader_.fail("column case: {}: allowed {}", shown(row.front()), allowed());
        }
        if (next) {
            check_case();
            ++begun_;
        }
        row.erase(row.begin());
        if (const std::string flaw = flaw_of(experiment_.columns, row); !flaw.empty()) reader_.fail("{}", flaw);
        table_.cases[wanted_[begun_ - 1]].push_back(std::move(row));
    }

    /// At the line that begins as the last one does.
    void end() {
        check_case();
        const std::string count = reader_.line().substr(table_end_mark.size());
        if (count != std::to_string(begun_)) {
            reader_.fail("end = {}: allowed {}, the number of cases above", shown(count), begun_);
        }
        if (begun_ < wanted_.size()) reader_.fail("case {} is missing above", wanted_[begun_]);
        if (!reader_.at_end()) reader_.fail("there is more after the end");
    }

private:
    [[nodiscard]] std::string allowed() const {
        std::string text = begun_ > 0 ? std::to_string(wanted_[begun_ - 1]) : "";
        if (begun_ < wanted_.size()) text += (text.empty() ? "" : " or ") + std::to_string(wanted_[begun_]);
        return (text.empty() ? "none" : text) + ", by 'settings' and 'cases' above";
    }

    /// The rows of the case that has been read last.
    void check_case() const {
        if (begun_ == 0) return;
        const std::size_t number = wanted_[begun_ - 1];
        const std::string flaw = experiment_.flaw_of_case(table_.cases.at(number));
        if (!flaw.empty()) reader_.fail("case {} above: {}", number, flaw);
    }

    const Experiment& experiment_;
    LineReader& reader_;
    ExperimentTable& table_;
    std::vector<std::size_t> wanted_;
    std::size_t begun_ = 0;
};

/// @return false if there is no such file
bool open(const std::filesystem::path& file, std::ifstream& in) {
    if (!exists(file)) return false;
    // Not before it is known to be a file: a pipe would be waited for
    if (is_regular_file(file)) in.open(file, std::ios::binary);
    if (!in.is_open()) throw InputError(file.string() + ": cannot be read");
    return true;
}

}  // namespace

std::optional<ExperimentTable> read_table(const Experiment& experiment, std::istream& in, const std::string& name,
                                          bool unfinished) {
    LineReader reader(in, name, unfinished);
    ExperimentTable table;
    if (!read_head(experiment, reader, table.head)) {
        if (unfinished) return {};
        reader.fail("there is no table");
    }
    RowReader rows(experiment, reader, table);
    while (reader.next()) {
        if (reader.line().starts_with(table_end_mark)) {
            rows.end();
            return table;
        }
        rows.add();
    }
    if (!unfinished) reader.fail("cut off: expected '{}', the number of cases", table_end_mark);
    // Its last rows may be missing. Cases are computed in ascending order
    if (!table.cases.empty()) table.cases.erase(std::prev(table.cases.end()));
    return table;
}

std::optional<ExperimentTable> read_table(const Experiment& experiment, const std::filesystem::path& file,
                                          bool unfinished) {
    std::ifstream in;
    if (!open(file, in)) return {};
    return read_table(experiment, in, file.string(), unfinished);
}

std::optional<TableHead> read_head(const Experiment& experiment, const std::filesystem::path& file) try {
    std::ifstream in;
    TableHead head;
    if (!open(file, in)) return {};
    LineReader reader(in, file.string(), true);
    if (!read_head(experiment, reader, head)) return {};
    return head;
} catch (const InputError&) {
    return {};
}

}  // namespace drape
