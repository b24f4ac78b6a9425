#pragma once

#include <istream>
#include <span>
#include <string>

#include "drape/base/real.h"
#include "drape/model/grid.h"
#include "lab/experiment/experiment.h"

namespace drape {

class CommandLine;

// Each adds a subcommand. Those that can fail without throwing set `exit_code` when they have run.

/// `simulate`: runs a scene to given times and writes states, statistics and hash.
void add_simulate(CommandLine& line, int& exit_code);

/// `collide`: prints which triangles of given positions touch a ball.
void add_collide(CommandLine& line);

/// Reads the positions of `collide`: one x,y,z a line, in particle order.
/// @param file names it in messages
/// @throws InputError as `file:line: ...`
Points read_positions(std::istream& in, const std::string& file, const Grid& grid);

/// `needs`: searches for what a scene needs, or checks that it has no more.
void add_needs(CommandLine& line, int& exit_code);

// Of these the experiments outlive the parsing of the command line.

/// A subcommand for each experiment, which writes NAME.csv, NAME.html and, where there is gnuplot, the charts.
void add_experiments(CommandLine& line, std::span<const Experiment> experiments);

/// `merge`: joins the tables of shares into that of a single run.
void add_merge(CommandLine& line, std::span<const Experiment> experiments);

}  // namespace drape
