#include "experiment_table.h"

#include <array>
#include <ctime>
#include <fstream>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/read_line.h"
#include "drape/base/real.h"
#include "lab/commit.h"

namespace drape {
namespace {

constexpr std::size_t longest_line = 64 * 1024;

/// With which the last line begins, before the number of cases. Those without rows do not count.
constexpr std::string_view end_mark = "# end: ";

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
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

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    std::array<char, 16> text{};
    gmtime_r(&now, &parts);
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
    return text.data();
}

std::string joined(const TableRow& row) {
    std::string line;
    for (const std::string& cell : row) {
        DRAPE_ASSERT(cell.find_first_of(",\n") == std::string::npos);
        line += (&cell == row.data() ? "" : ",") + cell;
    }
    return line + "\n";
}

TableRow cut(const std::string& line) {
    TableRow row;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t comma = std::min(line.find(',', begin), line.size());
        row.push_back(line.substr(begin, comma - begin));
        begin = comma + 1;
    }
    return row;
}

std::string header_of(const Experiment& experiment) { return "case," + joined(experiment.columns); }

/// Reads line after line and tells where it is.
class TableReader {
public:
    TableReader(const std::filesystem::path& file, bool unfinished)
        : name_(file.string()), unfinished_(unfinished), in_(file, std::ios::binary) {}

    [[nodiscard]] bool is_open() const { return in_.is_open(); }

    bool next(std::string& line) {
        const LineEnd end = read_line(in_, line, longest_line);
        if (end == LineEnd::None) return false;
        ++number_;
        if (end == LineEnd::CutOff && unfinished_) return false;
        if (end != LineEnd::Whole) fail(end == LineEnd::CutOff ? "cut off" : "too long");
        return true;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(name_ + ":" + std::to_string(number_) + ": " + what);
    }

private:
    std::string name_;
    bool unfinished_;
    std::ifstream in_;
    int number_ = 0;
};

}  // namespace

TableHead head_of(const Experiment& experiment, const std::string& settings, std::size_t cases) {
    return {{"experiment", experiment.name},
            {"drape", std::string(DRAPE_VERSION) + (sizeof(Real) == 4 ? ", single" : ", double") + " precision"},
            {"commit", commit()},
            {"machine", processor()},
            {"compiler", compiler()},
            {"date", today()},
            {"settings", settings},
            {"cases", std::to_string(cases)}};
}

std::string line_of(const TableHead& head, const std::string& name) {
    for (const auto& [key, value] : head) {
        if (key == name) return value;
    }
    return "";
}

std::vector<TableRow> ExperimentTable::rows() const {
    std::vector<TableRow> all;
    for (const auto& [number, rows] : cases) all.insert(all.end(), rows.begin(), rows.end());
    return all;
}

std::optional<ExperimentTable> read_table(const Experiment& experiment, const std::filesystem::path& file,
                                          bool unfinished) {
    TableReader reader(file, unfinished);
    if (!reader.is_open()) return {};
    ExperimentTable table;
    std::string line;
    bool more = reader.next(line);
    for (; more && line.starts_with("# "); more = reader.next(line)) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) reader.fail("allowed '# name: value' before the table");
        table.head.emplace_back(line.substr(2, colon - 2), line.substr(colon + 2));
    }
    if (!more && unfinished) return {};
    if (!more) reader.fail("there is no table");
    if (line + "\n" != header_of(experiment)) reader.fail("these are not the columns of " + experiment.name);
    bool ended = false;
    while (reader.next(line)) {
        ended = line == std::string(end_mark) + std::to_string(table.cases.size());
        if (ended) break;
        TableRow row = cut(line);
        const auto number = parse_integer(row[0]);
        if (!number || *number < 1) reader.fail("case = " + row[0].substr(0, 100) + ": allowed case >= 1");
        if (row.size() != experiment.columns.size() + 1) {
            reader.fail(std::to_string(row.size()) + " cells: allowed " +
                        std::to_string(experiment.columns.size() + 1));
        }
        row.erase(row.begin());
        table.cases[static_cast<std::size_t>(*number)].push_back(std::move(row));
    }
    if (!ended && !unfinished) reader.fail("cut off: expected '" + std::string(end_mark) + "', the number of cases");
    // Its last rows may be missing. Cases are computed in ascending order
    if (!ended && !table.cases.empty()) table.cases.erase(std::prev(table.cases.end()));
    return table;
}

std::filesystem::path unfinished_name(const std::filesystem::path& file) { return file.string() + ".part"; }

TableWriter::TableWriter(const Experiment& experiment, const std::filesystem::path& file, const ExperimentTable& table)
    : file_(file), out_(unfinished_name(file).string()) {
    for (const auto& [key, value] : table.head) out_.stream() << "# " << key << ": " << value << '\n';
    out_.stream() << header_of(experiment);
    for (const auto& [number, rows] : table.cases) write(number, rows);
    // What was there is in it, and is not touched before
    out_.take_name();
}

void TableWriter::write(std::size_t number, const std::vector<TableRow>& rows) {
    std::string text;
    for (const TableRow& row : rows) text += std::to_string(number) + "," + joined(row);
    cases_ += rows.empty() ? 0 : 1;
    out_.stream() << text;
    out_.flush();
}

void TableWriter::finish() {
    out_.stream() << end_mark << cases_ << '\n';
    out_.close();
    if (exists(file_)) set_file_aside(file_);
    std::error_code error;
    rename(unfinished_name(file_), file_, error);
    if (error) throw RunError(file_.string() + ": cannot be written: " + error.message());
}

}  // namespace drape
