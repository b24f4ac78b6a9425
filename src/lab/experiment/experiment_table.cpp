#include "experiment_table.h"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <thread>

#include "drape/base/assert.h"
#include "drape/base/commit.h"
#include "drape/base/input_error.h"
#include "drape/base/real.h"

namespace drape {
namespace {

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

std::string joined(const TableRow& row) {
    for (const std::string& cell : row) DRAPE_ASSERT(cell.find_first_of(",\n") == std::string::npos);
    return fmt::format("{}\n", fmt::join(row, ","));
}

/// What is wrong with what a case has computed; empty if nothing is.
std::string flaw_of_rows(const Experiment& experiment, const std::vector<TableRow>& rows) {
    if (rows.empty()) return "it has no rows";
    for (const TableRow& row : rows) {
        if (const std::string flaw = flaw_of(experiment.columns, row); !flaw.empty()) return flaw;
    }
    return "";
}

}  // namespace

TableHead head_of(const Experiment& experiment, const std::string& settings, std::size_t cases) {
    return {{"experiment", experiment.name},
            {"drape", std::string(DRAPE_VERSION) + (sizeof(Real) == 4 ? ", single" : ", double") + " precision"},
            {"commit", commit()},
            {"machine", machine()},
            {"compiler", compiler()},
            {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))},
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

std::string columns_line(const Experiment& experiment) {
    std::string line = "case";
    for (const Column& column : experiment.columns) line += "," + column.name;
    return line;
}

std::filesystem::path unfinished_name(const std::filesystem::path& file) { return file.string() + ".part"; }

TableWriter::TableWriter(const Experiment& experiment, const std::filesystem::path& file, const ExperimentTable& table)
    : experiment_(experiment), file_(file), out_(unfinished_name(file).string()) {
    for (const auto& [key, value] : table.head) out_.stream() << "# " << key << ": " << value << '\n';
    out_.stream() << columns_line(experiment) << '\n';
    for (const auto& [number, rows] : table.cases) write(number, rows);
    // What was there is in it, and is not touched before
    out_.take_name();
}

void TableWriter::write(std::size_t number, const std::vector<TableRow>& rows) {
    // A table that could not be read back is none
    if (const std::string flaw = flaw_of_rows(experiment_, rows); !flaw.empty()) {
        throw RunError(experiment_.name + ": case " + std::to_string(number) + ": " + flaw);
    }
    std::string text;
    for (const TableRow& row : rows) text += std::to_string(number) + "," + joined(row);
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
