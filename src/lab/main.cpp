#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include "commands.h"
#include "drape/base/command_line.h"
#include "drape/base/run_program.h"
#include "drape/bounds/broad_phase.h"
#include "drape/integrate/integrator.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/session/tour.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// `list`: prints the names of scenes, settings, experiments, integrators or volumes.
void add_list(CommandLine& line, std::span<const Experiment> experiments) {
    const auto names = [](std::span<const std::string> all) {
        for (const std::string& name : all) std::cout << name << '\n';
    };
    const auto scenes = [] {
        for (const std::string& name : scene_names()) std::cout << name << ": " << load_scene(name).title << '\n';
    };
    const auto questions = [experiments] {
        for (const Experiment& one : experiments) std::cout << one.name << ": " << one.question << '\n';
    };
    const std::map<std::string, std::function<void()>> lists{
        {"scenes", scenes},
        {"settings", [] { std::cout << settings_help(); }},
        {"tour", [] { std::cout << tour_page(); }},
        {"experiments", questions},
        {"integrators", [=] { names(names_of<IntegratorKind>()); }},
        {"volumes", [=] { names(names_of<VolumeKind>()); }},
        {"updates", [=] { names(names_of<UpdateKind>()); }},
        {"fits", [=] { names(names_of<SphereFit>()); }}};
    std::vector<std::string> words;
    for (const auto& [word, print] : lists) words.push_back(word);
    auto what = std::make_shared<std::string>();
    CommandLine& command = line.command("list", "Prints what there is", [what, lists] { lists.at (*what)(); });
    command.option("what", *what, "of what", {"WHAT", true, words});
}

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
