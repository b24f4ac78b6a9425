#pragma once

#include <filesystem>
#include <span>

#include "experiment_table.h"

namespace drape {

class CommandLine;

/// Adds a subcommand for each experiment, which writes NAME.csv, index.html and, where there is gnuplot, the charts.
/// @param experiments outlive the parsing of the command line
void add_experiments(CommandLine& line, std::span<const Experiment> experiments);

/// Adds the subcommand that joins the tables of shares into that of a single run.
/// @param experiments outlive the parsing of the command line
void add_merge(CommandLine& line, std::span<const Experiment> experiments);

/// The values of a chart as gnuplot commands: plain variables, finite numbers, and texts of letters, digits and
/// " _:.+-" in single quotes.
/// @throws RunError if there is any other
std::string assignments_of(const Chart& chart);

/// Shows a finished table: prints the summary, draws the charts beside it as SVG and PNG, each by NAME.gnuplot, which
/// stays there for who wants to change it, and writes index.html, which opens from disk and needs nothing but these.
/// Says which charts had nothing to draw, unless the table has only some of the cases.
/// @throws RunError if a file cannot be read or written, or gnuplot fails
void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file);

}  // namespace drape
