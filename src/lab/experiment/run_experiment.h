#pragma once

#include <filesystem>

#include "experiment.h"
#include "experiment_table.h"

namespace CLI {
class App;
}

namespace drape {

/// Adds a subcommand for each experiment, which writes NAME.csv, index.html and, where there is gnuplot, the charts.
/// @param exit_code set when the subcommand has run
void add_experiments(CLI::App& app, int& exit_code);

/// Shows a finished table: prints the summary, draws the charts, writes the page.
void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file);

}  // namespace drape
