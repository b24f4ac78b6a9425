#include "fuzz/small_run.h"

#include <algorithm>

#include "drape/scene/setting_table.h"
#include "fuzz/target.h"

namespace drape::fuzz {
namespace {

constexpr int max_particles = 150;
constexpr int steps = 2;

}  // namespace

std::optional<Settings> made_small(Settings settings) {
    int particles = 0;
    for (const ClothParameters& cloth : settings.cloths) {
        const Grid& grid = cloth.particles;
        if (grid.nx > max_particles || grid.ny > max_particles) return {};
        particles += grid.particles();
        if (particles > max_particles) return {};
    }
    settings.start.clear();  // any file could be named
    std::erase_if(settings.solids, [](const SolidSettings& solid) { return solid.shape == SolidKind::Mesh; });
    settings.solver.iterations = std::min(settings.solver.iterations, 20);
    settings.solver.threads = std::min(settings.solver.threads, 2);
    return settings;
}

void step_a_little(Simulation& simulation) {
    for (int step = 0; step < steps; ++step) {
        simulation.step();
        for (const Cloth& cloth : simulation.cloths()) {
            require(cloth.state.x.allFinite() && cloth.state.v.allFinite(), "the state that is shown is finite");
        }
    }
}

bool same_settings(const Settings& one, const Settings& other) {
    return std::ranges::all_of(setting_table(), [&](const Setting& setting) {
        const std::size_t parts = section_count(one, setting);
        if (parts != section_count(other, setting)) return false;
        for (std::size_t i = 0; i < parts; ++i) {
            if (setting.read(one, i) != setting.read(other, i)) return false;
        }
        return true;
    });
}

}  // namespace drape::fuzz
