#include "experiment_table.h"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

#include "drape/base/assert.h"
#include "drape/base/commit.h"
#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/real.h"

namespace drape {
namespace {

constexpr std::size_t longest_line = 16 * 1024;          // bytes: a line of a merged head names every machine
constexpr std::size_t largest_table = 32 * 1024 * 1024;  // bytes: the largest of a whole run has 5 million
constexpr std::size_t most_parts = 10000;

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
        const std::string model = line.substr(std::min(line.find(':') + 2, line.size()));
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

/// The last line of a table: one that has none was cut off.
std::string end_line(std::size_t cases) { return fmt::format("# end: {}", cases); }

/// Nothing that gnuplot, a shell or a page would take for more than a word or a number.
bool is_plain(std::string_view cell) {
    return std::ranges::all_of(
        cell, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '+' || c == '-'; });
}

}  // namespace

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

TableHead head_of(const Experiment& experiment, const CaseSelection& selection, std::size_t cases) {
    std::string settings = selection.quick ? "--quick" : "whole";
    if (!selection.cases.empty()) settings += " --cases " + selection.cases;
    if (!selection.share.empty()) settings += " --share " + selection.share;
    return {{"experiment", experiment.name},
            {"drape", std::string(DRAPE_VERSION) + (sizeof(Real) == 4 ? ", single" : ", double") + " precision"},
            {"commit", commit()},
            {"machine", machine()},
            {"compiler", compiler()},
            {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))},
            {"settings", settings},
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

ExperimentTable read_table(const Experiment& experiment, std::istream& in, const std::string& name) {
    NumberedLines lines{in, name, longest_line};
    ExperimentTable table;
    for (const std::string line : head_lines) {
        const std::string mark = "# " + line + ": ";
        if (!lines.next()) lines.fail("there is no table");
        if (!std::ranges::all_of(lines.line, [](char c) { return c >= ' ' && c <= '~'; })) {
            lines.fail("allowed is plain ASCII");
        }
        if (!lines.line.starts_with(mark)) {
            lines.fail(fmt::format("'{}': allowed '{}' of a head", shortened(lines.line), mark));
        }
        table.head[line] = lines.line.substr(mark.size());
    }
    const Columns& columns = experiment.columns;
    if (!lines.next() || table.head["experiment"] != experiment.name || lines.line != columns_line(experiment)) {
        lines.fail("this is no table of " + experiment.name + ", or of another version");
    }
    while (lines.next()) {
        if (lines.line.starts_with('#')) {
            const std::string end = end_line(table.cases.size());
            if (lines.line != end) lines.fail(fmt::format("'{}': allowed '{}'", shortened(lines.line), end));
            if (lines.next()) lines.fail("there is more after the end");
            return table;
        }
        const auto cells = split_at_commas(lines.line);
        if (cells.size() != columns.size() + 1) {
            lines.fail(fmt::format("{} cells: allowed {}", cells.size(), columns.size() + 1));
        }
        const long long number = parse_integer(cells[0]).value_or(0);
        if (number < 1 || (!table.cases.empty() && number < static_cast<long long>(table.cases.rbegin()->first))) {
            lines.fail("case '" + shortened(cells[0]) + "': allowed that of the row above, or a greater one");
        }
        Row& row = table.cases[static_cast<std::size_t>(number)].emplace_back();
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (!is_plain(cells[k + 1])) {
                lines.fail(fmt::format("column {}: '{}': allowed letters, digits and any of _.+-", columns[k].name,
                                       shortened(cells[k + 1])));
            }
            row.set(columns[k].name, std::string(cells[k + 1]));
        }
    }
    lines.fail("cut off: expected '" + end_line(table.cases.size()) + "'");
}

std::optional<ExperimentTable> read_table(const Experiment& experiment, const std::filesystem::path& file) {
    if (!exists(file)) return {};
    InputFile in(file.string(), largest_table, InputKind::Regular);
    return read_table(experiment, in, file.string());
}

void write_table(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file) {
    OutputFile out(file.string());
    for (const char* line : head_lines) out.stream() << "# " << line << ": " << table.head.at(line) << '\n';
    out.stream() << columns_line(experiment) << '\n';
    for (const auto& [number, rows] : table.cases) {
        DRAPE_ASSERT(!rows.empty());
        for (const Row& row : rows) {
            const auto texts = row.texts(experiment.columns, experiment.digits);
            out.stream() << fmt::format("{},{}\n", number, fmt::join(texts, ","));
        }
    }
    out.stream() << end_line(table.cases.size()) << '\n';
    out.close();
}

std::filesystem::path unfinished_name(const std::filesystem::path& file) { return file.string() + ".part"; }

void finish_table(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file) {
    write_table(experiment, table, unfinished_name(file));
    if (exists(file)) set_file_aside(file);
    std::error_code error;
    rename(unfinished_name(file), file, error);
    if (error) throw RunError(file.string() + ": cannot be written: " + error.message());
}

}  // namespace drape
