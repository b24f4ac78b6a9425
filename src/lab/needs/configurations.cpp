#include "needs.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "drape/base/input_error.h"
#include "drape/scene/scene.h"

namespace drape {

std::set<Knob> free_knobs(const Settings& scene) {
    const auto names = names_of<Knob>();
    const auto all = values_of<Knob>();
    std::set<Knob> knobs(all.begin(), all.end());
    std::string keep = scene.needs.keep;
    std::ranges::replace(keep, ',', ' ');
    std::istringstream words(keep);
    for (std::string word; words >> word;) {
        const auto knob = value_named<Knob>(word);
        if (!knob) {
            throw InputError("needs.keep: '" + shortened(word) + "': allowed " + listed(names) +
                             did_you_mean(word, names));
        }
        knobs.erase(*knob);
    }
    if (scene.cloths[0].pinned.kind == Pins::Kind::List || !scene.start.empty()) knobs.erase(Knob::Particles);
    if (scene.balls.empty()) {
        for (const Knob knob : hierarchy_knobs) knobs.erase(knob);
    }
    return knobs;
}

Settings on_grid(Settings scene, const Grid& grid) {
    ClothParameters& cloth = scene.cloths[0];
    if (grid == cloth.particles) return scene;
    cloth.drag *= static_cast<Real>(cloth.particles.particles()) / static_cast<Real>(grid.particles());
    cloth.particles = grid;
    return scene;
}

std::optional<Settings> one_notch_less(const Settings& scene, Knob knob) {
    if (!free_knobs(scene).contains(knob)) return std::nullopt;
    Settings less = scene;
    ClothParameters& cloth = less.cloths[0];
    if (knob == Knob::Particles) {
        constexpr int fewest_cells = 4;  // a side
        const auto fewer = [](int particles) { return static_cast<int>(std::lround(0.8 * (particles - 1))); };
        const int across = fewer(cloth.particles.nx), along = fewer(cloth.particles.ny);
        if (std::min(across, along) < fewest_cells) return std::nullopt;
        return on_grid(scene, {across + 1, along + 1});
    }
    if (knob == Knob::Bend) cloth.bend = {};
    if (knob == Knob::Drag) cloth.drag = 0;
    if (knob == Knob::Dt) {
        const double clearly_longer = 1.0001 * scene.solver.dt;
        for (const double dt : step_ladder) {
            if (dt > clearly_longer) less.solver.dt = dt;
        }
    }
    if (knob == Knob::Iterations && method_of(scene.solver.integrator).iterates && scene.solver.iterations > 1) {
        --less.solver.iterations;
    }
    if (cloth == scene.cloths[0] && less.solver == scene.solver) return std::nullopt;
    return less;
}

Settings full_model(const Settings& scene) {
    if (scene.cloths.size() != 1) throw InputError("needs: allowed only scenes with one cloth");
    const FullModelSettings& full = scene.needs.full;
    Settings model = scene;
    if (full.particles != Grid{0, 0}) {
        if (std::min(full.particles.nx, full.particles.ny) < 2) {
            throw InputError("needs.full.particles: allowed at least 2 columns and 2 rows");
        }
        model = on_grid(model, full.particles);
    }
    if (full.bend != SpringLaw{}) model.cloths[0].bend = full.bend;
    if (full.drag > 0) model.cloths[0].drag = full.drag;
    return model;
}

Settings computed_closely(Settings scene, double dt) {
    scene.solver.integrator = IntegratorKind::DormandPrince;
    scene.solver.tolerance = 0;
    scene.solver.dt = dt;
    scene.contact.search_level = SearchLimit::all_levels;
    scene.contact.search_tests = 0;
    return scene;
}

std::string text_of_found(Settings scene, const Settings& full, const std::filesystem::path& file) {
    const ClothParameters& cloth = full.cloths[0];
    scene.needs.full = {cloth.particles, cloth.bend, cloth.drag};
    // A scene names its start state as seen from its own folder
    if (!scene.start.empty()) {
        scene.start = std::filesystem::relative(scene.start, absolute(file).parent_path()).string();
        if (scene.start.starts_with("..")) {
            throw InputError("--write " + file.string() + ": allowed in the folder of the scene's start, or above it");
        }
    }
    return scene_text(scene);
}

}  // namespace drape
