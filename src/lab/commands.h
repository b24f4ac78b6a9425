#pragma once

#include <span>

#include "lab/experiment/experiment.h"

namespace drape {

class CommandLine;

// Each adds a subcommand. Those that can fail without throwing set `exit_code` when they have run.

/// `simulate`: runs a scene to given times and writes states, statistics and hash.
void add_simulate(CommandLine& line, int& exit_code);

/// `collide`: prints which triangles of given positions touch a ball.
void add_collide(CommandLine& line);

/// `needs`: searches for what a scene needs, or checks that it has no more.
void add_needs(CommandLine& line, int& exit_code);

/// `list`: prints the names of scenes, settings, experiments, integrators or volumes.
/// @param experiments outlive the parsing of the command line
void add_list(CommandLine& line, std::span<const Experiment> experiments);

}  // namespace drape
