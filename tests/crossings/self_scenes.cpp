#include "self_scenes.h"

#include <cmath>

#include "drape/integrate/stability.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"

namespace drape::crossings {
namespace {

/// What stands in the same row, and at the same end of it, on another grid.
int moved_to(const Grid& to, const Grid& from, int particle) {
    const int row = particle / from.nx, column = particle % from.nx;
    const Real place = static_cast<Real>(row) / static_cast<Real>(from.ny - 1);
    const auto new_row = static_cast<int>(std::lround(place * static_cast<Real>(to.ny - 1)));
    return to.particle(column == 0 ? 0 : to.nx - 1, new_row);
}

/// Pins of whole rows.
std::vector<int> rows_of_pins(const Grid& to, const Grid& from, const std::vector<int>& pins) {
    std::vector<int> list;
    for (const int pin : pins) {
        if (pin % from.nx > 0) continue;
        const int first = moved_to(to, from, pin);
        for (int i = 0; i < to.nx; ++i) list.push_back(first + i);
    }
    return list;
}

}  // namespace

Settings scene_of_side(const std::string& scene, int side) {
    Settings settings = load_scene(scene);
    if (side == 0) return settings;
    for (PinSettings& pins : settings.pins) {
        const Grid from = settings.cloths[static_cast<std::size_t>(pins.cloth)].particles;
        pins.particles = {moved_to({side, side}, from, pins.particles.nx),
                          moved_to({side, side}, from, pins.particles.ny)};
    }
    for (ClothParameters& cloth : settings.cloths) {
        const Grid from = std::exchange(cloth.particles, Grid{side, side});
        cloth.drag *= static_cast<Real>(from.particles()) / static_cast<Real>(side * side);
        if (cloth.pinned.kind == Pins::Kind::List) {
            cloth.pinned.list = rows_of_pins(cloth.particles, from, cloth.pinned.list);
        }
    }
    return settings;
}

bool use_method(Settings& settings, IntegratorKind integrator) {
    settings.solver.integrator = integrator;
    if (!has_step_limit(integrator)) {
        settings.solver.dt = 1.0 / 240;
        return true;
    }
    const double longest = Simulation("limit", settings).longest_step();
    settings.solver.dt = std::min(settings.solver.dt, 0.8 * longest);
    return longest > 0;
}

}  // namespace drape::crossings
