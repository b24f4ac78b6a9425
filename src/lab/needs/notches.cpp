#include "notches.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drape/base/input_error.h"

namespace drape {
namespace {

constexpr std::array ordered{Knob::Particles, Knob::Bend, Knob::Drag, Knob::Dt, Knob::Iterations};

/// A decade of the ladder of steps [1e-7 s], and the decades that are tried.
constexpr std::array decade{1000, 1250, 1600, 2000, 2500, 3125, 4000, 5000, 6250, 8000};
constexpr std::array decades{1e9, 1e8, 1e7, 1e6, 1e5};
constexpr double longest = 1.0 / 60, shortest = 1e-5;  // s

constexpr int fewest_cells = 4;  // a side

int fewer_cells(int particles) { return static_cast<int>(std::lround(0.8 * (particles - 1))); }

}  // namespace

std::span<const Knob> ordered_knobs() { return ordered; }

bool has_iterations(IntegratorKind kind) {
    return kind == IntegratorKind::Xpbd || kind == IntegratorKind::ProjectiveDynamics;
}

std::set<Knob> free_knobs(const Settings& scene) {
    const auto names = names_of<Knob>();
    std::set<Knob> knobs;
    for (std::size_t k = 0; k < names.size(); ++k) knobs.insert(static_cast<Knob>(k));
    const std::string& keep = scene.needs.keep;
    constexpr const char* between = ", ";
    for (std::size_t begin = keep.find_first_not_of(between); begin < keep.size();) {
        const std::size_t end = std::min(keep.find_first_of(between, begin), keep.size());
        const std::string word = keep.substr(begin, end - begin);
        const auto found = std::find(names.begin(), names.end(), word);
        if (found == names.end()) {
            throw InputError("needs.keep: '" + shortened(word) + "': allowed " + listed(names) + "; did you mean '" +
                             nearest_name(word, names) + "'?");
        }
        knobs.erase(static_cast<Knob>(found - names.begin()));
        begin = keep.find_first_not_of(between, end);
    }
    if (scene.cloths[0].pinned.kind == Pins::Kind::List || !scene.start.empty()) knobs.erase(Knob::Particles);
    if (scene.balls.empty()) {
        for (const Knob knob : {Knob::Volume, Knob::Update, Knob::SphereFit, Knob::LeafCells}) knobs.erase(knob);
    }
    return knobs;
}

std::vector<double> step_ladder() {
    std::vector<double> steps;
    for (const double unit : decades) {
        for (const int step : decade) {
            // A quotient of whole numbers is the nearest to the decimal number that is meant
            const double dt = step / unit;
            if (dt >= shortest && dt <= longest) steps.push_back(dt);
        }
    }
    std::sort(steps.rbegin(), steps.rend());
    return steps;
}

Settings on_grid(Settings scene, const Grid& grid) {
    ClothParameters& cloth = scene.cloths[0];
    if (grid == cloth.particles) return scene;
    cloth.drag *= static_cast<Real>(cloth.particles.particles()) / static_cast<Real>(grid.particles());
    cloth.particles = grid;
    return scene;
}

std::optional<Settings> one_notch_less(const Settings& scene, Knob knob) {
    Settings less = scene;
    ClothParameters& cloth = less.cloths[0];
    switch (knob) {
        case Knob::Particles: {
            const Grid grid = cloth.particles;
            const int across = fewer_cells(grid.nx), along = fewer_cells(grid.ny);
            if (std::min(across, along) < fewest_cells) return std::nullopt;
            return on_grid(scene, {across + 1, along + 1});
        }
        case Knob::Bend:
            if (cloth.bend == SpringLaw{}) return std::nullopt;
            cloth.bend = {};
            return less;
        case Knob::Drag:
            if (cloth.drag == 0) return std::nullopt;
            cloth.drag = 0;
            return less;
        case Knob::Dt: {
            const auto ladder = step_ladder();
            const double clearly_longer = 1.0001 * scene.solver.dt;
            const auto longer =
                std::find_if(ladder.rbegin(), ladder.rend(), [&](double dt) { return dt > clearly_longer; });
            if (longer == ladder.rend()) return std::nullopt;
            less.solver.dt = *longer;
            return less;
        }
        case Knob::Iterations:
            if (!has_iterations(scene.solver.integrator) || scene.solver.iterations <= 1) return std::nullopt;
            --less.solver.iterations;
            return less;
        default:
            return std::nullopt;
    }
}

}  // namespace drape
