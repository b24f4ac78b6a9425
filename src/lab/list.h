#pragma once

namespace CLI {
class App;
}

namespace drape {

/// Adds `list`: prints the names of scenes, settings, experiments, integrators or volumes.
/// @param exit_code set when the subcommand has run
void add_list(CLI::App& app, int& exit_code);

}  // namespace drape
