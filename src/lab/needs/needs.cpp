#include "lab/commands.h"

#include <fmt/ranges.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/run_program.h"
#include "drape/scene/setting_table.h"
#include "drape/session/start.h"
#include "needs.h"

namespace drape {
namespace {

struct NeedsOptions {
    StartOptions start;
    std::string write;
    bool check = false;
};

std::string value(const Settings& settings, const std::string& name) {
    return value_text(find_setting(name).read(settings, 0));
}

/// What a configuration is, in a line: its model, and how it is computed.
std::string described(const Settings& settings) {
    const ClothParameters& cloth = settings.cloths[0];
    const SolverSettings& solver = settings.solver;
    const std::string model = fmt::format("{}x{}{}{}", cloth.particles.nx, cloth.particles.ny,
                                          cloth.bend != SpringLaw{} ? " bend" : "", cloth.drag > 0 ? " drag" : "");
    if (solver.integrator == IntegratorKind::DormandPrince) return model + ", computed closely";
    return fmt::format("{}, {} {} s{}", model, name_of(solver.integrator), real_text(solver.dt),
                       method_of(solver.integrator).iterates ? fmt::format(" x {}", solver.iterations) : "");
}

/// How a configuration looks for contacts, after a comma; empty without a ball.
std::string hierarchy(const Settings& settings) {
    if (settings.balls.empty()) return "";
    std::string text = ",";
    for (const Knob knob : hierarchy_knobs) {
        const bool is_used = why_without_effect(find_setting(name_of(knob)), settings, 0).empty();
        if (is_used) text += " " + value(settings, name_of(knob));
    }
    return text;
}

/// One line of the trail.
void print(const Attempt& attempt, const std::string& outcome) {
    std::cout << fmt::format("{:>9}{:>10}  {:<55}  {}\n", std::isnan(attempt.error) ? "" : percent(attempt.error),
                             real_text(1e3 * attempt.cost, 3),
                             described(attempt.settings) + hierarchy(attempt.settings), outcome)
              << std::flush;
}

void print_head(const Needs& needs) {
    const NeedsSettings& stated = needs.scene().needs;
    const auto metres = [](Real x) { return real_text(static_cast<double>(x)) + " m"; };
    const auto part = [](Real x) { return percent(static_cast<double>(x)); };
    std::vector<std::string> must;
    if (needs.states_error()) {
        must.push_back(fmt::format("be within {} of its full model ({})", part(stated.position_error),
                                   value(needs.scene(), "needs.measure")));
    }
    if (stated.penetration > 0) must.push_back("let the ball in no deeper than " + metres(stated.penetration));
    if (stated.stretch > 0) must.push_back("stretch by no more than " + part(stated.stretch));
    if (stated.min_stretch > 0) must.push_back("stretch by " + part(stated.min_stretch));
    if (stated.diverges) must.emplace_back("diverge");
    std::cout << fmt::format("Up to {} s the scene must {}.\n", value(needs.scene(), "needs.horizon"),
                             fmt::join(must, ", "));
    if (!stated.keep.empty()) std::cout << "By its nature it keeps " << stated.keep << ".\n";
    if (needs.states_error()) {
        std::cout << "Full model: " << described(computed_closely(needs.full(), close_step)) << ".\n"
                  << needs.check_full_model();
    }
    std::cout << "    error      ms/s  tried\n";
}

/// Walks the notches of a scene as it is.
int check_scene(const Needs& needs) {
    const Attempt as_it_is = needs.attempt(needs.scene());
    print(as_it_is, as_it_is.qualifies() ? "the scene" : as_it_is.why);
    if (!as_it_is.qualifies()) {
        std::cout << "The scene does not show what it needs.\n";
        return Failed;
    }
    std::vector<Knob> spare;
    try_notches(needs, [&](Knob knob, const Attempt& less) {
        print(less, less.qualifies() ? "it qualifies: the scene has more than it needs" : less.why);
        if (less.qualifies()) spare.push_back(knob);
    });
    for (const Knob knob : spare) std::cout << "The scene has more than it needs of: " << name_of(knob) << "\n";
    if (!spare.empty()) return Failed;
    std::cout << "The scene is minimal: one notch less on any free knob that has an order breaks a need.\n";
    return Done;
}

int find(const Needs& needs, const std::string& file, OutputFile& out) {
    const Attempt found = search(needs, print);
    if (!found.qualifies()) {
        std::cout << "Nothing qualifies. The nearest miss is " << described(found.settings) << ": " << found.why
                  << (found.error > 0 ? " (" + percent(found.error) + ")" : "") << "\n";
        return Failed;
    }
    std::cout << fmt::format("The cheapest that qualifies is {}{}: {} ms of CPU time per simulated second{}.\n",
                             described(found.settings), hierarchy(found.settings), real_text(1e3 * found.cost, 3),
                             needs.states_error() ? ", error " + percent(found.error) : "");
    if (out.wanted()) {
        out.stream() << text_of_found(found.settings, needs.full(), file);
        out.close();
        std::cout << "Written to " << file << ".\n";
    }
    return Done;
}

int run(const NeedsOptions& options) {
    const Start start = make_start(options.start);
    check_written(options.start, start, {{"--write", options.write}});
    // What would be refused at the end is refused at once
    if (!options.write.empty()) text_of_found(start.settings, start.settings, options.write);
    OutputFile out(options.write);
    try {
        const Needs needs(start.settings);
        print_head(needs);
        return options.check ? check_scene(needs) : find(needs, options.write, out);
    } catch (const InputError& error) {
        throw InputError(options.start.scene + ": " + error.what());
    }
}

}  // namespace

void add_needs(CommandLine& line, int& exit_code) {
    auto options = std::make_shared<NeedsOptions>();
    CommandLine& command =
        line.command("needs", "Searches for the cheapest configuration that shows what the scene's [needs] state",
                     [options, &exit_code] { exit_code = run(*options); });
    command.option("scene", options->start.scene, "name of a shipped scene, or a TOML file", {"SCENE", true});
    command.option("--set", options->start.assignments, "change settings", {"name=value"});
    command.option("--write", options->write, "write the scene that was found, with what --set has changed",
                   {"FILE.toml"});
    command.flag("--check", options->check,
                 "only whether the scene is minimal: what one notch less on each free knob that has an order "
                 "(particles, bend, drag, dt, iterations) would break",
                 "--write");
    command.footer([] { return "Settings:\n" + settings_help(); });
}

}  // namespace drape
