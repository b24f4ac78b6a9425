#include "list.h"

#include "drape/base/program.h"
#include "drape/bounds/broad_phase.h"
#include "drape/integrate/integrator.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"
#include "lab/experiment/experiment.h"

namespace drape {
namespace {

void print(std::span<const std::string> names) {
    for (const std::string& name : names) std::cout << name << '\n';
}

void print_scenes() {
    for (const std::string& name : scene_names()) std::cout << name << ": " << load_scene(name).title << '\n';
}

void print_experiments() {
    for (const Experiment& experiment : experiments()) {
        std::cout << experiment.name << ": " << experiment.question << '\n';
    }
}

void list(const std::string& what) {
    if (what == "scenes") print_scenes();
    if (what == "settings") std::cout << settings_help();
    if (what == "integrators") print(names_of<IntegratorKind>());
    if (what == "volumes") print(names_of<VolumeKind>());
    if (what == "updates") print(names_of<UpdateKind>());
    if (what == "fits") print(names_of<SphereFit>());
    if (what == "experiments") print_experiments();
}

}  // namespace

void add_list(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("list", "Prints what there is");
    auto what = std::make_shared<std::string>();
    command->add_option("what", *what, "of what")
        ->required()
        ->check(CLI::IsMember({"scenes", "settings", "experiments", "integrators", "volumes", "updates", "fits"}));
    command->callback([what, &exit_code] {
        list(*what);
        exit_code = Done;
    });
}

}  // namespace drape
