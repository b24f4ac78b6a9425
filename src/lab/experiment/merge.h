#pragma once

namespace CLI {
class App;
}

namespace drape {

/// Adds the subcommand that joins the tables of shares into that of a single run.
/// @param exit_code set when the subcommand has run
void add_merge(CLI::App& app, int& exit_code);

}  // namespace drape
