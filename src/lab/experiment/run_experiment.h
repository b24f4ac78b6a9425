#pragma once

#include <filesystem>
#include <span>

#include "experiment.h"
#include "experiment_table.h"

namespace CLI {
class App;
}

namespace drape {

/// Adds a subcommand for each experiment, which writes NAME.csv, index.html and, where there is gnuplot, the charts.
/// @param experiments outlive the parsing of the command line
/// @param exit_code set when the subcommand has run
void add_experiments(CLI::App& app, std::span<const Experiment> experiments, int& exit_code);

/// Adds the subcommand that joins the tables of shares into that of a single run.
/// @param experiments outlive the parsing of the command line
/// @param exit_code set when the subcommand has run
void add_merge(CLI::App& app, std::span<const Experiment> experiments, int& exit_code);

/// Shows a finished table: prints the summary, draws the charts, writes the page.
void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file);

}  // namespace drape
