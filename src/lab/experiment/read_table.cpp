#include <algorithm>
#include <array>

#include "case_selection.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "experiment_table.h"
#include "lab/line_reader.h"

namespace drape {
namespace {

constexpr std::size_t longest_table_line = 16 * 1024;    // bytes: a line of a merged head names every machine
constexpr std::size_t largest_table = 32 * 1024 * 1024;  // bytes: the largest of a whole run has 5 million
constexpr long long most_cases = 100'000;

std::string shown(const std::string& text) { return std::string(1, '\'').append(text, 0, 100) + "'"; }

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

/// Reads a table line after line, and checks each.
class TableReader {
public:
    TableReader(const Experiment& experiment, std::istream& in, const std::string& name, bool unfinished)
        : experiment_(experiment), reader_(in, name, longest_table_line), unfinished_(unfinished) {}

    /// Reads the head and the line that names the columns.
    /// @return false where it is cut off before that line ends
    bool read_head() {
        bool more = next();
        for (; more && reader_.line().starts_with("# "); more = next()) add_to_head();
        if (!more) return false;
        if (reader_.line() != columns_line(experiment_)) {
            reader_.fail("these are not the columns of {}", experiment_.name);
        }
        for (const std::string& name : head_names) {
            if (!has_line(name)) reader_.fail("'# {}: ' is missing above the columns", name);
        }
        return true;
    }

    [[nodiscard]] const TableHead& head() const { return table_.head; }

    /// Reads all of it.
    std::optional<ExperimentTable> read() {
        if (!read_head()) {
            if (unfinished_) return {};
            reader_.fail("there is no table");
        }
        find_wanted();
        while (next()) {
            if (!reader_.line().starts_with(table_end_mark)) {
                add_row();
                continue;
            }
            check_end();
            return std::move(table_);
        }
        if (!unfinished_) reader_.fail("cut off: expected '{}', the number of cases", table_end_mark);
        // Its last rows may be missing. Cases are computed in ascending order
        if (!table_.cases.empty()) table_.cases.erase(std::prev(table_.cases.end()));
        return std::move(table_);
    }

private:
    /// False at the end, or where an unfinished table is cut off.
    bool next() {
        const LineEnd end = reader_.next();
        if (end == LineEnd::None) return false;
        const std::string& line = reader_.line();
        if (end == LineEnd::CutOff && unfinished_) return false;
        if (end == LineEnd::CutOff) reader_.fail("cut off");
        const auto foreign = std::ranges::find_if(line, [](char c) { return c < ' ' || c > '~'; });
        if (foreign != line.end()) reader_.fail("byte {} is no printable ASCII character", foreign - line.begin() + 1);
        return true;
    }

    [[nodiscard]] bool has_line(const std::string& name) const {
        return std::ranges::any_of(table_.head, [&name](const auto& line) { return line.first == name; });
    }

    void add_to_head() {
        const std::string& line = reader_.line();
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) reader_.fail("allowed '# name: value' before the table");
        const std::string name = line.substr(2, colon - 2), value = line.substr(colon + 2);
        if (std::ranges::find(head_names, name) == head_names.end()) {
            reader_.fail("head line {}: allowed {}", shown(name), listed(head_names));
        }
        if (has_line(name)) reader_.fail("{} is there twice", name);
        if (const std::string flaw = flaw_of_line(experiment_, name, value); !flaw.empty()) reader_.fail("{}", flaw);
        table_.head.emplace_back(name, value);
    }

    /// The cases that a table with this head has when it is finished.
    void find_wanted() try {
        const auto count = parse_integer(line_of(table_.head, "cases")).value();
        wanted_ = parse_selection(line_of(table_.head, "settings"))->numbers(static_cast<std::size_t>(count));
    } catch (const InputError& error) {
        reader_.fail("the settings above have {}", error.what());
    }

    void add_row() {
        const auto cells = split_at_commas(reader_.line());
        TableRow row(cells.begin(), cells.end());
        if (row.size() != experiment_.columns.size() + 1) {
            reader_.fail("{} cells: allowed {}", row.size(), experiment_.columns.size() + 1);
        }
        const auto number = parse_integer(row.front());
        const auto is = [&number](std::size_t other) { return number == static_cast<long long>(other); };
        if (begun_ < wanted_.size() && is(wanted_[begun_])) {
            ++begun_;
        } else if (begun_ == 0 || !is(wanted_[begun_ - 1])) {
            reader_.fail("column case: {}: allowed {}", shown(row.front()), allowed_case());
        }
        row.erase(row.begin());
        if (const std::string flaw = flaw_of(experiment_.columns, row); !flaw.empty()) reader_.fail("{}", flaw);
        table_.cases[wanted_[begun_ - 1]].push_back(std::move(row));
    }

    [[nodiscard]] std::string allowed_case() const {
        std::string text = begun_ > 0 ? std::to_string(wanted_[begun_ - 1]) : "";
        if (begun_ < wanted_.size()) text += (text.empty() ? "" : " or ") + std::to_string(wanted_[begun_]);
        return (text.empty() ? "none" : text) + ", by 'settings' and 'cases' above";
    }

    /// At the line that begins as the last one does.
    void check_end() const {
        const std::string count = reader_.line().substr(table_end_mark.size());
        if (count != std::to_string(begun_)) {
            reader_.fail("end = {}: allowed {}, the number of cases above", shown(count), begun_);
        }
        if (begun_ < wanted_.size()) reader_.fail("case {} is missing above", wanted_[begun_]);
        if (!reader_.at_end()) reader_.fail("there is more after the end");
    }

    const Experiment& experiment_;
    LineReader reader_;
    bool unfinished_;
    ExperimentTable table_;
    std::vector<std::size_t> wanted_;  ///< numbers of the cases
    std::size_t begun_ = 0;            ///< how many of them
};

}  // namespace

std::optional<ExperimentTable> read_table(const Experiment& experiment, std::istream& in, const std::string& name,
                                          bool unfinished) {
    return TableReader(experiment, in, name, unfinished).read();
}

std::optional<ExperimentTable> read_table(const Experiment& experiment, const std::filesystem::path& file,
                                          bool unfinished) {
    if (!exists(file)) return {};
    InputFile in(file.string(), largest_table, InputKind::Regular);
    return read_table(experiment, in, file.string(), unfinished);
}

std::optional<TableHead> read_head(const Experiment& experiment, const std::filesystem::path& file) try {
    if (!exists(file)) return {};
    InputFile in(file.string(), largest_table, InputKind::Regular);
    TableReader reader(experiment, in, file.string(), true);
    if (!reader.read_head()) return {};
    return reader.head();
} catch (const InputError&) {
    return {};
}

}  // namespace drape
