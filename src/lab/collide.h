#pragma once

namespace CLI {
class App;
}

namespace drape {

/// Adds `collide`: prints which triangles of given positions touch a ball.
/// @param exit_code set when the subcommand has run
void add_collide(CLI::App& app, int& exit_code);

}  // namespace drape
