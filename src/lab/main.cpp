#include "commands.h"
#include "drape/base/program.h"
#include "lab/experiment/run_experiment.h"
#include "lab/experiments.h"

namespace drape {
namespace {

int run(int argc, char** argv) {
    CLI::App app("Simulates, collides, measures and lists, with no picture.", "drape-lab");
    app.require_subcommand(1);
    const std::vector<Experiment> experiments = all_experiments();
    int exit_code = Done;
    add_simulate(app, exit_code);
    add_collide(app, exit_code);
    add_needs(app, exit_code);
    add_list(app, experiments, exit_code);
    add_experiments(app, experiments, exit_code);
    add_merge(app, experiments, exit_code);
    parse_command_line(app, argc, argv);
    return exit_code;
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("drape-lab", argc, argv, drape::run); }
