#pragma once

namespace CLI {
class App;
}

namespace drape {

/// Adds `needs`: finds the cheapest configuration of a scene that shows what the scene needs.
/// @param exit_code set when the subcommand has run
void add_needs(CLI::App& app, int& exit_code);

}  // namespace drape
