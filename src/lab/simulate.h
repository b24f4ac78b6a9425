#pragma once

namespace CLI {
class App;
}

namespace drape {

/// Adds `simulate`: runs a scene to given times and writes states, statistics and hash.
/// @param exit_code set when the subcommand has run
void add_simulate(CLI::App& app, int& exit_code);

}  // namespace drape
