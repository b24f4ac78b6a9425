#include "drape/session/failure.h"

#include <sstream>
#include <string_view>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/output_file.h"
#include "drape/scene/mesh_file.h"
#include "drape/scene/scene.h"
#include "drape/session/state_csv.h"

namespace drape {
namespace {

/// What cannot be read is no text of ours; nor is a pipe, for whose other end nobody waits.
bool has_text(const std::filesystem::path& file, const std::string& text) {
    try {
        return read_text(file.string()) == text;
    } catch (const InputError&) {
        return false;
    }
}

/// @return false if there is such a file by now
bool write_new_file(const std::filesystem::path& file, const std::string& text) {
    OutputFile out(file.string());
    out.stream() << text;
    return out.close_if_free();
}

/// With which the title of a scene begins that was written here.
constexpr std::string_view fails_mark = "Fails at once: ";

/// The settings with pins and substeps as they are now; where cloths and balls are, the state says.
Settings present_settings(const Simulation& simulation) {
    Settings settings = simulation.settings();
    settings.solver.dt /= simulation.report().substeps;
    if (settings.solver.on_unstable == OnUnstable::Substep) settings.solver.on_unstable = OnUnstable::Warn;
    const auto cloths = simulation.cloths();
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Pins pins{Pins::Kind::List, {}};
        for (int p = 0; p < cloths[c].model.grid.particles(); ++p) {
            if (cloths[c].model.pinned(p)) pins.list.push_back(p);
        }
        const ClothModel as_set = make_cloth_model(settings.cloths[c]);
        if ((as_set.inverse_mass != cloths[c].model.inverse_mass).any()) settings.cloths[c].pinned = pins;
    }
    return settings;
}

/// Puts the meshes of solids beside a scene, which may name no others.
/// @return false if there are other files of these names
bool keep_meshes(const Settings& settings, const std::filesystem::path& folder, const std::string& name,
                 Settings& written) {
    for (std::size_t s = 0; s < settings.solids.size(); ++s) {
        if (settings.solids[s].file.empty()) continue;
        const std::string copy = name + "-solid-" + std::to_string(s) + mesh_extension(settings.solids[s].file);
        const std::string text = read_text(settings.solids[s].file);
        if (!has_text(folder / copy, text) && !write_new_file(folder / copy, text)) return false;
        written.solids[s].file = copy;
    }
    return true;
}

}  // namespace

std::filesystem::path write_failure(const Simulation& simulation, const std::filesystem::path& folder) {
    DRAPE_ASSERT(simulation.report().status == Status::Diverged);
    std::ostringstream state;
    write_state_header(state, simulation);
    write_state(state, simulation);
    Settings settings = present_settings(simulation);
    if (!settings.title.starts_with(fails_mark)) settings.title = std::string(fails_mark) + settings.title;
    const std::string warning = simulation.step_warning();
    const std::string remark = "# " + simulation.report().error + "\n" + (warning.empty() ? "" : "# " + warning + "\n");
    for (int number = 1;; ++number) {
        const std::string name = number == 1 ? "unstable" : "unstable-" + std::to_string(number);
        const auto scene_file = folder / (name + ".toml"), state_file = folder / (name + ".csv");
        settings.start = state_file.filename().string();
        if (!keep_meshes(simulation.settings(), folder, name, settings)) continue;
        const std::string scene = remark + scene_text(settings);
        if (exists(scene_file) || exists(state_file)) {
            // The same failure again, after a reset
            if (has_text(scene_file, scene) && has_text(state_file, state.str())) return scene_file;
            continue;
        }
        // Another program may have failed in the same folder meanwhile
        if (!write_new_file(state_file, state.str())) continue;
        if (write_new_file(scene_file, scene)) return scene_file;
        std::error_code ignored;
        std::filesystem::remove(state_file, ignored);
    }
}

std::string tell_failure(const Simulation& simulation, const std::filesystem::path& folder) {
    const std::string warning = simulation.step_warning(), cause = warning.empty() ? "" : warning + "; ";
    // The energy that has ended it is the sum of many steps
    if (simulation.run_warning().ends_with(simulation.report().error)) return cause + "no step of it alone shows this";
    try {
        return cause + write_failure(simulation, folder).string() + " starts from the last good state";
    } catch (const std::exception& error) {
        return cause + error.what();
    }
}

std::vector<std::string> state_notices(const Simulation& simulation, const std::string& failure) {
    const StepReport& report = simulation.report();
    if (report.error.empty()) {
        const std::string warning = simulation.step_warning();
        return warning.empty() ? std::vector<std::string>() : std::vector{warning};
    }
    const double longest = simulation.longest_step();
    const bool shorter_helps = longest > 0 && simulation.settings().solver.dt > 0.9 * longest;
    std::vector<std::string> notices{report.error};
    const std::string& note = failure.empty() ? simulation.step_warning() : failure;
    if (!note.empty()) notices.push_back(note);
    notices.push_back(std::string("R resets with the same time step") +
                      (shorter_helps ? ", Shift+R with 0.9 of its limit" : ""));
    return notices;
}

}  // namespace drape
