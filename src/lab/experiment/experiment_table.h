#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiment.h"

namespace drape {

/// Which cases of an experiment a run computes, as its options say it and its table's head.
struct CaseSelection {
    bool quick = false;
    std::string cases = {};  ///< "FIRST-LAST"; empty for all
    std::string share = {};  ///< "K/N", the K-th of N parts: K, K + N, K + 2N, ...; empty for all

    /// The numbers of the cases, ascending from 1.
    /// @param count of all cases that there are
    /// @throws InputError that names the option if a part of it is none
    [[nodiscard]] std::vector<std::size_t> numbers(std::size_t count) const;
};

/// The names of the lines at the head of a table, in their order.
inline constexpr const char* head_lines[] = {"experiment", "drape", "commit",   "machine",
                                             "compiler",   "date",  "settings", "cases"};

/// What a table says of where it is from, by the names of its lines: "machine", "Intel ...".
using TableHead = std::map<std::string, std::string>;

/// The head of a table that is computed here and now.
/// @param cases that there are in all
TableHead head_of(const Experiment& experiment, const CaseSelection& selection, std::size_t cases);

/// The first line in which two heads differ, but for some that may: "commit: A, not B"; empty if there is none.
std::string difference(const TableHead& head, const TableHead& wanted, const std::set<std::string>& but);

/// A table in a file: head, names of columns, and the rows of each case, with its number before them.
struct ExperimentTable {
    TableHead head;
    std::map<std::size_t, Rows> cases;  ///< rows by number of the case, from 1

    /// The rows of all cases in their order.
    [[nodiscard]] Rows rows() const;
};

/// Reads a table that an experiment has written. One that was cut off, or has rows of another table between its own, is
/// refused; so is a cell that is no plain word or number, whatever it is that somebody has put there.
/// @param name of the file, for messages
/// @throws InputError with name and line, if it is not such a table
ExperimentTable read_table(const Experiment& experiment, std::istream& in, const std::string& name);

/// The same of a file.
/// @return nothing if there is no such file
/// @throws InputError also if it cannot be read, or is larger than a table may be
std::optional<ExperimentTable> read_table(const Experiment& experiment, const std::filesystem::path& file);

/// Writes a table, whole or not at all.
/// @pre each case has rows
/// @throws RunError if it cannot be written, or has a cell that no column has
void write_table(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file);

/// Under which a table has the cases that are done until all are.
std::filesystem::path unfinished_name(const std::filesystem::path& file);

/// Writes a table as the unfinished one, and gives that its own name. What had it is kept under a numbered one.
/// @throws RunError as `write_table`
void finish_table(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file);

/// Shows a finished table: draws the charts beside it as SVG and PNG, each by NAME.gnuplot, which stays there for who
/// wants to change it, and writes NAME.html, which opens from disk and needs nothing but these. Prints where that is,
/// and says which charts had nothing to draw, unless the table has only some of the cases.
/// @throws RunError if a file cannot be read or written, or gnuplot fails
void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file);

}  // namespace drape
