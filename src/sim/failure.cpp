#include "drape/sim/failure.h"

#include <algorithm>

#include "drape/base/output_file.h"
#include "drape/sim/scene_text.h"
#include "drape/sim/state_csv.h"

namespace drape {
namespace {

/// The first of unstable, unstable-2, unstable-3, ... of which there is no file yet.
std::string free_name(const std::filesystem::path& folder) {
    std::string name = "unstable";
    for (int number = 2; exists(folder / (name + ".toml")) || exists(folder / (name + ".csv")); ++number) {
        name = "unstable-" + std::to_string(number);
    }
    return name;
}

/// The settings with cloths, balls and pins as they are now.
Settings present_settings(const Simulation& simulation) {
    Settings settings = simulation.settings();
    const auto cloths = simulation.cloths();
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Pins pins{Pins::Kind::List, {}};
        for (int p = 0; p < cloths[c].model.grid.particles(); ++p) {
            if (cloths[c].model.pinned(p)) pins.list.push_back(p);
        }
        const ClothModel as_set = make_cloth_model(settings.cloths[c]);
        if ((as_set.inverse_mass != cloths[c].model.inverse_mass).any()) settings.cloths[c].pinned = pins;
    }
    for (std::size_t b = 0; b < settings.balls.size(); ++b) {
        settings.balls[b].position = simulation.balls()[b].centre;
        settings.balls[b].velocity = simulation.balls()[b].velocity;
    }
    return settings;
}

}  // namespace

std::filesystem::path write_failure(const Simulation& simulation, const std::filesystem::path& folder) {
    const std::string name = free_name(folder);
    Settings settings = present_settings(simulation);
    settings.title = "Fails in its first step: " + settings.title;
    settings.start = name + ".csv";
    OutputFile state((folder / settings.start).string());
    write_state_header(state.stream(), simulation);
    write_state(state.stream(), simulation);
    state.close();
    std::filesystem::path file = folder / (name + ".toml");
    OutputFile scene(file.string());
    scene.stream() << "# " << simulation.report().trouble << "\n" << scene_text(settings);
    scene.close();
    return file;
}

std::string tell_failure(const Simulation& simulation, const std::filesystem::path& folder) {
    try {
        return write_failure(simulation, folder).string() + " starts from the last good state";
    } catch (const std::exception& error) {
        return error.what();
    }
}

}  // namespace drape
