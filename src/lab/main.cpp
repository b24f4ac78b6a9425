#include "commands.h"
#include "drape/base/command_line.h"
#include "drape/base/run_program.h"
#include "lab/experiments.h"

namespace drape {
namespace {

int run(int argc, char** argv) {
    CommandLine line("drape-lab", "Simulates, collides, measures and lists, with no picture.");
    const std::vector<Experiment> experiments = all_experiments();
    int exit_code = Done;
    add_simulate(line, exit_code);
    add_collide(line);
    add_needs(line, exit_code);
    add_list(line, experiments);
    add_experiments(line, experiments);
    add_merge(line, experiments);
    line.parse(argc, argv);
    return exit_code;
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("drape-lab", argc, argv, drape::run); }
