#pragma once

#include <span>

#include "lab/experiment/experiment.h"

namespace CLI {
class App;
}

namespace drape {

// Each adds a subcommand, which sets `exit_code` when it has run.

/// `simulate`: runs a scene to given times and writes states, statistics and hash.
void add_simulate(CLI::App& app, int& exit_code);

/// `collide`: prints which triangles of given positions touch a ball.
void add_collide(CLI::App& app, int& exit_code);

/// `needs`: searches for what a scene needs, or checks that it has no more.
void add_needs(CLI::App& app, int& exit_code);

/// `list`: prints the names of scenes, settings, experiments, integrators or volumes.
/// @param experiments outlive the parsing of the command line
void add_list(CLI::App& app, std::span<const Experiment> experiments, int& exit_code);

}  // namespace drape
