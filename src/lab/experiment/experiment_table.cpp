#include "experiment_table.h"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <regex>
#include <string_view>
#include <thread>

#include "drape/base/commit.h"
#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/base/real.h"
#include "lab/line_reader.h"

namespace drape {
namespace {

constexpr std::size_t longest_table_line = 16 * 1024;    // bytes: a line of a merged head names every machine
constexpr std::size_t largest_table = 32 * 1024 * 1024;  // bytes: the largest of a whole run has 5 million
constexpr long long most_cases = 100'000;
constexpr std::size_t most_parts = 10000;
constexpr std::string_view table_end_mark = "# end: ";  // before the number of its cases

/// Two numbers with a mark between.
/// @throws InputError unless 1 <= first <= second <= most
std::pair<std::size_t, std::size_t> parse_pair(const std::string& text, char mark, std::size_t most,
                                               const std::string& option, const char* first, const char* second) {
    const auto pair = parse_integers(text, mark);
    if (pair && pair->first >= 1 && pair->first <= pair->second && pair->second <= static_cast<long long>(most)) {
        return *pair;
    }
    throw InputError(fmt::format("{} {}: allowed {}{}{} with 1 <= {} <= {} <= {}", option, shortened(text), first, mark,
                                 second, first, second, most));
}

/// The processor and how many cores of it this program may use.
std::string machine() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("model name")) continue;
        std::string model = line.substr(std::min(line.find(':') + 2, line.size()));
        std::ranges::replace_if(
            model, [](char c) { return c < ' ' || c > '~'; }, '?');
        return fmt::format("{} with {} cores", model, std::thread::hardware_concurrency());
    }
    return "unknown";
}

std::string compiler() {
#ifdef __clang__
    return __VERSION__;
#else
    return "g++ " __VERSION__;
#endif
}

std::string columns_line(const Experiment& experiment) {
    std::string line = "case";
    for (const Column& column : experiment.columns) line += "," + column.name;
    return line;
}

/// Reads a table line after line, and checks each.
class TableReader : LineReader {
public:
    TableReader(const Experiment& experiment, std::istream& in, const std::string& name, bool unfinished)
        : LineReader(in, name, longest_table_line), experiment_(experiment), unfinished_(unfinished) {}

    /// @return nothing where it is cut off before its head ends
    std::optional<TableHead> read_head() {
        TableHead head;
        for (const std::string name : head_lines) {
            if (!next()) return {};
            const std::string mark = "# " + name + ": ";
            if (!line().starts_with(mark)) fail("'{}': allowed '{}' of a head", shortened(line()), mark);
            head[name] = line().substr(mark.size());
        }
        return head;
    }

    /// Reads all of it.
    std::optional<ExperimentTable> read() {
        const auto head = read_head();
        const auto wanted = head ? cases_of(*head) : std::vector<std::size_t>{};
        if (!head || !next()) {
            if (unfinished_) return {};
            fail("there is no table");
        }
        if (line() != columns_line(experiment_)) fail("these are not the columns of {}", experiment_.name);
        ExperimentTable table{*head, {}};
        while (next()) {
            if (line().starts_with(table_end_mark)) {
                check_end(table.cases.size(), wanted);
                return table;
            }
            const auto cells = split_at_commas(line());
            if (cells.size() != experiment_.columns.size() + 1) {
                fail("{} cells: allowed {}", cells.size(), experiment_.columns.size() + 1);
            }
            const std::size_t number = case_of(cells.front(), table.cases.size(), wanted);
            const TableRow texts(cells.begin() + 1, cells.end());
            if (const std::string flaw = flaw_of(experiment_.columns, texts); !flaw.empty()) fail("{}", flaw);
            Row& row = table.cases[number].emplace_back();
            for (std::size_t k = 0; k < texts.size(); ++k) row.set(experiment_.columns[k].name, texts[k]);
            // No digit may vanish where the row is written again
            const TableRow again = row.texts(experiment_.columns, experiment_.digits);
            for (std::size_t k = 0; k < texts.size(); ++k) {
                if (texts[k] == again[k]) continue;
                fail("column {}: '{}': allowed '{}', as a run writes it", experiment_.columns[k].name,
                     shortened(texts[k]), again[k]);
            }
        }
        if (!unfinished_) fail("cut off: expected '{}', the number of cases", table_end_mark);
        // Its last rows may be missing. Cases are computed in ascending order
        if (!table.cases.empty()) table.cases.erase(std::prev(table.cases.end()));
        return table;
    }

private:
    /// False at the end, or where an unfinished table is cut off.
    bool next() {
        const LineEnd end = LineReader::next();
        if (end == LineEnd::None || (end == LineEnd::CutOff && unfinished_)) return false;
        if (end == LineEnd::CutOff) fail("cut off");
        const auto foreign = std::ranges::find_if(line(), [](char c) { return c < ' ' || c > '~'; });
        if (foreign != line().end()) {
            fail("byte {} is no printable ASCII character", foreign - line().begin() + 1);
        }
        return true;
    }

    /// The numbers of the cases that a table with this head has when it is finished.
    [[nodiscard]] std::vector<std::size_t> cases_of(const TableHead& head) const {
        const auto demand = [&](const std::string& name, bool good, const std::string& allowed) {
            if (!good) fail("{} = '{}' above: allowed {}", name, shortened(head.at(name)), allowed);
        };
        const long long count = parse_integer(head.at("cases")).value_or(0);
        const auto selection = parse_selection(head.at("settings"));
        demand("experiment", head.at("experiment") == experiment_.name, "'" + experiment_.name + "'");
        demand("settings", selection.has_value(),
               "'whole' or '--quick', then ' --cases FIRST-LAST' and ' --share K/N' or nothing");
        demand("cases", count >= 1 && count <= most_cases, fmt::format("1 to {}", most_cases));
        try {
            return selection->numbers(static_cast<std::size_t>(count));
        } catch (const InputError& error) {
            fail("the settings above have {}", error.what());
        }
    }

    /// The case of a row: that of the row above, or the one that follows it.
    /// @param begun how many of those wanted there are above
    [[nodiscard]] std::size_t case_of(std::string_view cell, std::size_t begun,
                                      const std::vector<std::size_t>& wanted) const {
        std::vector<std::string> allowed;
        for (std::size_t k = begun > 0 ? begun - 1 : 0; k <= begun && k < wanted.size(); ++k) {
            allowed.push_back(std::to_string(wanted[k]));
            if (cell == allowed.back()) return wanted[k];
        }
        fail("column case: '{}': allowed {}, by 'settings' and 'cases' above", shortened(cell),
             allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, " or ")));
    }

    /// At the line that begins as the last one does.
    /// @param there how many cases are above
    void check_end(std::size_t there, const std::vector<std::size_t>& wanted) const {
        const std::string end = fmt::format("{}{}", table_end_mark, there);
        if (line() != end) fail("'{}': allowed '{}', the number of cases above", shortened(line()), end);
        if (there < wanted.size()) fail("case {} is missing above", wanted[there]);
        if (!at_end()) fail("there is more after the end");
    }

    const Experiment& experiment_;
    bool unfinished_;
};

}  // namespace

std::string CaseSelection::text() const {
    std::string all = quick ? "--quick" : "whole";
    if (!cases.empty()) all += " --cases " + cases;
    if (!share.empty()) all += " --share " + share;
    return all;
}

std::vector<std::size_t> CaseSelection::numbers(std::size_t count) const {
    const auto range =
        parse_pair(cases.empty() ? fmt::format("1-{}", count) : cases, '-', count, "--cases", "FIRST", "LAST");
    const auto part = parse_pair(share.empty() ? "1/1" : share, '/', most_parts, "--share", "K", "N");
    std::vector<std::size_t> wanted;
    for (std::size_t number = range.first; number <= range.second; ++number) {
        if (number % part.second == part.first % part.second) wanted.push_back(number);
    }
    return wanted;
}

std::optional<CaseSelection> parse_selection(const std::string& text) {
    static const std::regex form("(--quick|whole)(?: --cases ([^ ]+))?(?: --share ([^ ]+))?");
    std::smatch parts;
    // The matcher's depth is that of the text
    if (text.size() > 1000 || !std::regex_match(text, parts, form)) return {};
    return CaseSelection{parts[1] == "--quick", parts[2], parts[3]};
}

TableHead head_of(const Experiment& experiment, const CaseSelection& selection, std::size_t cases) {
    return {{"experiment", experiment.name},
            {"drape", std::string(DRAPE_VERSION) + (sizeof(Real) == 4 ? ", single" : ", double") + " precision"},
            {"commit", commit()},
            {"machine", machine()},
            {"compiler", compiler()},
            {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))},
            {"settings", selection.text()},
            {"cases", std::to_string(cases)}};
}

std::string difference(const TableHead& head, const TableHead& wanted, const std::set<std::string>& but) {
    for (const std::string line : head_lines) {
        if (but.contains(line) || head.at(line) == wanted.at(line)) continue;
        return line + ": " + head.at(line) + ", not " + wanted.at(line);
    }
    return "";
}

Rows ExperimentTable::rows() const {
    Rows all;
    for (const auto& [number, rows] : cases) all.insert(all.end(), rows.begin(), rows.end());
    return all;
}

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
    return TableReader(experiment, in, file.string(), true).read_head();
} catch (const InputError&) {
    return {};
}

std::filesystem::path unfinished_name(const std::filesystem::path& file) { return file.string() + ".part"; }

TableWriter::TableWriter(const Experiment& experiment, const std::filesystem::path& file, const ExperimentTable& table)
    : experiment_(experiment), file_(file), out_(unfinished_name(file).string()) {
    for (const char* line : head_lines) out_.stream() << "# " << line << ": " << table.head.at(line) << '\n';
    out_.stream() << columns_line(experiment) << '\n';
    for (const auto& [number, rows] : table.cases) write(number, rows);
    // What was there is in it, and is not touched before
    out_.take_name();
}

void TableWriter::write(std::size_t number, const Rows& rows) {
    std::string text, flaw = rows.empty() ? "it has no rows" : "";
    for (const Row& row : rows) {
        const TableRow texts = row.texts(experiment_.columns, experiment_.digits);
        if (flaw.empty()) flaw = flaw_of(experiment_.columns, texts);
        text += fmt::format("{},{}\n", number, fmt::join(texts, ","));
    }
    // A table that could not be read back is none
    if (!flaw.empty()) throw RunError(fmt::format("{}: case {}: {}", experiment_.name, number, flaw));
    ++cases_;
    out_.stream() << text;
    out_.flush();
}

void TableWriter::finish() {
    out_.stream() << table_end_mark << cases_ << '\n';
    out_.close();
    if (exists(file_)) set_file_aside(file_);
    std::error_code error;
    rename(unfinished_name(file_), file_, error);
    if (error) throw RunError(file_.string() + ": cannot be written: " + error.message());
}

}  // namespace drape
