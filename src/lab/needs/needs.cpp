#include "lab/commands.h"

#include <filesystem>
#include <iomanip>

#include "drape/base/numbers.h"
#include "drape/base/program.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/start.h"
#include "full_model.h"
#include "needs_search.h"
#include "write_scene.h"

namespace drape {
namespace {

struct NeedsOptions {
    StartOptions start;
    bool write = false, check = false;
};

std::string value(const Settings& settings, const std::string& name) {
    return value_text(find_setting(name).read(settings, 0));
}

/// What a configuration is, in a line: its model, and how it is computed.
std::string described(const Settings& settings) {
    const ClothParameters& cloth = settings.cloths[0];
    std::string text = std::to_string(cloth.particles.nx) + "x" + std::to_string(cloth.particles.ny);
    if (cloth.bend != SpringLaw{}) text += " bend";
    if (cloth.drag > 0) text += " drag";
    const IntegratorKind kind = settings.solver.integrator;
    if (kind == IntegratorKind::DormandPrince) return text + ", computed closely";
    text += ", " + std::string(name_of(kind)) + " " + real_text(settings.solver.dt) + " s";
    if (has_iterations(kind)) text += " x " + std::to_string(settings.solver.iterations);
    return text;
}

/// How a configuration looks for contacts.
std::string hierarchy(const Settings& settings) {
    std::string text = value(settings, "volume");
    if (settings.contact.volume == VolumeKind::Brute) return text;
    for (const char* name : {"update", "sphere_fit", "leaf_cells"}) {
        if (name != std::string("sphere_fit") || settings.contact.volume == VolumeKind::Sphere) {
            text += " " + value(settings, name);
        }
    }
    return text;
}

/// One line of the trail.
void print(const Needs& needs, const Attempt& attempt, const std::string& outcome) {
    const bool has_error = needs.states_error() && (attempt.error > 0 || attempt.qualifies());
    std::cout << std::setw(9) << (has_error ? percent(attempt.error) : "") << std::setw(10)
              << real_text(1e3 * attempt.cost, 3) << "  " << std::left << std::setw(55)
              << described(attempt.settings) +
                     (attempt.settings.balls.empty() ? "" : ", " + hierarchy(attempt.settings))
              << std::right << "  " << outcome << std::endl;
}

void print_head(const Needs& needs) {
    const NeedsSettings& stated = needs.scene().needs;
    std::cout << "Up to " << value(needs.scene(), "needs.horizon") << " s the scene must";
    const char* link = " ";
    const auto say = [&link](const std::string& need) {
        std::cout << link << need;
        link = ", ";
    };
    if (needs.states_error()) {
        say("be within " + percent(static_cast<double>(stated.position_error)) + " of its full model (" +
            value(needs.scene(), "needs.measure") + ")");
    }
    const auto metres = [](Real x) { return real_text(static_cast<double>(x)) + " m"; };
    if (stated.penetration > 0) say("let the ball in no deeper than " + metres(stated.penetration));
    if (stated.stretch > 0) say("stretch by no more than " + percent(static_cast<double>(stated.stretch)));
    if (stated.least_stretch > 0) say("stretch by " + percent(static_cast<double>(stated.least_stretch)));
    if (stated.diverges) say("diverge");
    std::cout << ".\n";
    if (!stated.keep.empty()) std::cout << "By its nature it keeps " << stated.keep << ".\n";
    if (needs.states_error()) {
        std::cout << "Full model: " << described(computed_closely(needs.full(), close_step)) << ".\n"
                  << needs.check_full_model();
    }
    std::cout << std::setw(9) << "error" << std::setw(10) << "ms/s"
              << "  tried\n";
}

/// Walks the notches of a scene as it is.
int check_scene(const Needs& needs, const Trail& trail) {
    const Attempt as_it_is = needs.attempt(needs.scene());
    trail(as_it_is, as_it_is.qualifies() ? "the scene" : as_it_is.why);
    if (!as_it_is.qualifies()) {
        std::cout << "The scene does not show what it needs.\n";
        return Failed;
    }
    const auto spare = spare_notches(needs, trail);
    for (const Knob knob : spare) {
        std::cout << "The scene has more than it needs of: " << name_of(knob) << "\n";
    }
    if (spare.empty())
        std::cout << "The scene is minimal: one notch less on any free knob that has an order breaks a need.\n";
    return spare.empty() ? Done : Failed;
}

int find(const Needs& needs, const Trail& trail, const std::optional<std::filesystem::path>& write_to) {
    const SearchResult result = search(needs, trail);
    if (!result.cheapest) {
        std::cout << "Nothing qualifies.";
        if (result.nearest) {
            std::cout << " The nearest miss is " << described(result.nearest->settings) << ": " << result.nearest->why;
            if (result.nearest->error > 0) std::cout << " (" << percent(result.nearest->error) << ")";
        }
        std::cout << "\n";
        return Failed;
    }
    const Settings& found = result.cheapest->settings;
    std::cout << "The cheapest that qualifies is " << described(found);
    if (!found.balls.empty()) std::cout << ", " << hierarchy(found);
    std::cout << ": " << real_text(1e3 * result.cheapest->cost, 3) << " ms of CPU time per simulated second";
    if (needs.states_error()) std::cout << ", error " << percent(result.cheapest->error);
    std::cout << ".\n";
    if (write_to) {
        write_scene(with_full_model(found, needs.full()), *write_to);
        std::cout << "Written to " << write_to->string() << ".\n";
    }
    return Done;
}

int run(const NeedsOptions& options) {
    const Settings scene = make_start(options.start).settings;
    // Refused before the search, which takes minutes
    std::optional<std::filesystem::path> write_to;
    if (options.write) write_to = file_of_scene(options.start.scene);
    try {
        const Needs needs(scene);
        print_head(needs);
        const Trail trail = [&needs](const Attempt& attempt, const std::string& outcome) {
            print(needs, attempt, outcome);
        };
        return options.check ? check_scene(needs, trail) : find(needs, trail, write_to);
    } catch (const InputError& error) {
        throw InputError(options.start.scene + ": " + error.what());
    }
}

}  // namespace

void add_needs(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "needs", "Searches for the cheapest configuration that shows what the scene's [needs] state");
    auto options = std::make_shared<NeedsOptions>();
    command->add_option("scene", options->start.scene, "name of a shipped scene, or a TOML file")
        ->type_name("SCENE")
        ->required();
    command->add_option("--set", options->start.assignments, "change settings")->type_name("name=value");
    CLI::Option* write =
        command->add_flag("--write", options->write,
                          "write what was found to the scene's file, which stays as NAME.toml~, or to a new NAME.toml "
                          "in the current folder "
                          "for a shipped scene's name; comments go, and what --set has changed is written too");
    command
        ->add_flag(
            "--check", options->check,
            "only whether the scene is minimal: what one notch less on each free knob that has an order (particles, "
            "bend, drag, dt, iterations) would break")
        ->excludes(write);
    command->footer([] { return "Settings:\n" + settings_help(); });
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace drape
