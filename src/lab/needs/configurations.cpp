#include "configurations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "drape/base/input_error.h"
#include "drape/base/output_file.h"
#include "drape/scene/scene.h"

namespace drape {
namespace {

constexpr std::array ordered{Knob::Particles, Knob::Bend, Knob::Drag, Knob::Dt, Knob::Iterations};

/// A decade of the ladder of steps [1e-7 s], and the decades that are tried.
constexpr std::array decade{1000, 1250, 1600, 2000, 2500, 3125, 4000, 5000, 6250, 8000};
constexpr std::array decades{1e9, 1e8, 1e7, 1e6, 1e5};
constexpr double longest_trial_step = 1.0 / 60, shortest_trial_step = 1e-5;  // s

constexpr int fewest_cells = 4;  // a side

int fewer_cells(int particles) { return static_cast<int>(std::lround(0.8 * (particles - 1))); }

}  // namespace

std::span<const Knob> ordered_knobs() { return ordered; }

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
            if (dt >= shortest_trial_step && dt <= longest_trial_step) steps.push_back(dt);
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
    if (knob == Knob::Particles) {
        const int across = fewer_cells(cloth.particles.nx), along = fewer_cells(cloth.particles.ny);
        if (std::min(across, along) < fewest_cells) return std::nullopt;
        return on_grid(scene, {across + 1, along + 1});
    }
    if (knob == Knob::Bend) cloth.bend = {};
    if (knob == Knob::Drag) cloth.drag = 0;
    if (knob == Knob::Dt) {
        const double clearly_longer = 1.0001 * scene.solver.dt;
        for (const double dt : step_ladder()) {
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

namespace files = std::filesystem;

Settings with_full_model(Settings found, const Settings& full) {
    const ClothParameters& cloth = full.cloths[0];
    found.needs.full = {cloth.particles, cloth.bend, cloth.drag};
    return found;
}

std::filesystem::path file_of_scene(const std::string& name_or_path) {
    const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
    if (is_path) return name_or_path;
    const std::string file = name_or_path + ".toml";
    std::error_code ignored;
    if (files::exists(files::symlink_status(file, ignored))) {
        throw InputError("--write: " + file + " is there already, and may be another scene: allowed ./" + file +
                         ", to read and write that one, or another folder");
    }
    return file;
}

namespace {

/// A scene names its start state as seen from its own folder.
std::string start_from(const files::path& file, const std::string& start) {
    const auto true_path = [](const files::path& path) { return files::weakly_canonical(files::absolute(path)); };
    return true_path(start).lexically_relative(true_path(files::absolute(file).parent_path())).string();
}

}  // namespace

void check_written_start(const Settings& scene, const std::filesystem::path& file) {
    if (scene.start.empty() || !start_from(file, scene.start).starts_with("..")) return;
    throw InputError("--write: start = " + scene.start + ": allowed only a file in the folder of " + file.string() +
                     " or below, which that scene may name");
}

void write_scene(const Settings& scene, const std::filesystem::path& file) {
    Settings written = scene;
    if (!written.start.empty()) written.start = start_from(file, written.start);
    OutputFile out(file.string());
    out.stream() << scene_text(written);
    const files::path target = link_target(file);
    if (files::exists(target)) {
        const files::path kept = target.string() + "~";
        UnfinishedFile copy(kept);
        std::error_code error;
        files::copy_file(target, copy.name(), files::copy_options::overwrite_existing, error);
        if (!error) files::permissions(copy.name(), files::status(target).permissions(), error);
        if (error) throw RunError(kept.string() + ": cannot be written: " + error.message());
        copy.finish();
    }
    out.close();
}

}  // namespace drape
