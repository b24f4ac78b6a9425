#include "needs.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "drape/base/input_error.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

/// The knobs that change the motion and have an order: a scene can have one notch less of each.
constexpr std::array ordered_knobs{Knob::Particles, Knob::Bend, Knob::Drag, Knob::Dt, Knob::Iterations};

/// The steps that are tried, longest first: ten a decade, rounded so that nearly all divide a tenth of a second [s].
constexpr std::array step_ladder{1.6e-2,   1.25e-2, 1e-2,    8e-3,    6.25e-3, 5e-3,    4e-3,    3.125e-3, 2.5e-3,
                                 2e-3,     1.6e-3,  1.25e-3, 1e-3,    8e-4,    6.25e-4, 5e-4,    4e-4,     3.125e-4,
                                 2.5e-4,   2e-4,    1.6e-4,  1.25e-4, 1e-4,    8e-5,    6.25e-5, 5e-5,     4e-5,
                                 3.125e-5, 2.5e-5,  2e-5,    1.6e-5,  1.25e-5, 1e-5};

/// Times of two runs differ by more than this without a cause [ratio].
constexpr double noise = 1.15;

/// Cheaper by less than this is no reason to change how a scene is searched [ratio].
constexpr double worth_it = 0.97;

class NeedsSearch {
public:
    NeedsSearch(const Needs& needs, const Trail& trail)
        : needs_(needs), trail_(trail), free_(free_knobs(needs.scene())) {}

    Attempt find() {
        if (needs_.states_error()) {
            find_method();
        } else {
            take(needs_.full());
        }
        if (cheapest_) {
            take_notches();
            choose_hierarchy();
        }
        return cheapest_ ? *cheapest_ : *nearest_;
    }

private:
    /// The full model and what is left of it, the least first.
    std::vector<Settings> models() {
        std::vector<Settings> found{needs_.full()};
        for (const Knob knob : {Knob::Particles, Knob::Bend, Knob::Drag}) {
            while (const auto less = one_notch_less(found.front(), knob)) {
                const Attempt attempt = needs_.attempt(computed_closely(*less, close_step));
                note(attempt, "kept: enough of a model");
                if (!attempt.qualifies()) break;
                found.insert(found.begin(), *less);
            }
        }
        return found;
    }

    /// The cheapest of all methods on all models.
    void find_method() {
        using enum IntegratorKind;
        const std::vector all{SymplecticEuler,  VelocityVerlet, Rk4,
                              ExplicitEuler,    BackwardEuler,  Bdf2,
                              ImplicitMidpoint, Xpbd,           ProjectiveDynamics};
        const SolverSettings& own = needs_.scene().solver;
        for (const Settings& model : models()) {
            for (const IntegratorKind kind : tried(Knob::Integrator, own.integrator, all)) {
                Settings method = model;
                method.solver.integrator = kind;
                const std::vector passes =
                    method_of(kind).iterates ? std::vector{1, 2, 5, 10} : std::vector{own.iterations};
                for (const int iterations : tried(Knob::Iterations, own.iterations, passes)) {
                    method.solver.iterations = iterations;
                    find_step(method);
                }
            }
        }
    }

    /// The longest step that qualifies. Of the many beyond the method's limit, the trail shows the last.
    void find_step(Settings method) {
        std::optional<Attempt> beyond;
        const std::vector ladder(step_ladder.begin(), step_ladder.end());
        for (const double dt : tried(Knob::Dt, needs_.scene().solver.dt, ladder)) {
            method.solver.dt = dt;
            Attempt attempt = needs_.attempt(method, cost_of_cheapest() * noise);
            if (attempt.beyond_limit) {
                beyond = attempt;
                continue;
            }
            if (beyond) note(*beyond, "");
            beyond.reset();
            const bool cheaper = attempt.qualifies() && is_cheaper(attempt, 1);
            note(attempt, cheaper ? "cheapest so far" : "more expensive than the cheapest so far");
            if (cheaper) cheapest_ = attempt;
            // A shorter step is more expensive still
            if (attempt.qualifies() || attempt.cost > cost_of_cheapest() * noise) return;
        }
        if (beyond) note(*beyond, "");
    }

    /// Takes notches away until one less of any knob breaks a need.
    void take_notches() {
        for (bool taken = true; taken;) {
            taken = false;
            for (const Knob knob : ordered_knobs) {
                while (const auto less = one_notch_less(cheapest_->settings, knob)) {
                    if (!take(*less)) break;
                    taken = true;
                }
            }
        }
    }

    bool take(const Settings& settings) {
        const Attempt attempt = needs_.attempt(settings);
        note(attempt, "kept: it needs no more");
        if (attempt.qualifies()) cheapest_ = attempt;
        return attempt.qualifies();
    }

    /// Volume, update, fit and leaf size, the cheapest by repeated timing. The motion is the same, unless the search
    /// ends at a limit: what lies below it depends on all of them.
    void choose_hierarchy() {
        for (const Knob knob : hierarchy_knobs) {
            const Setting& setting = find_setting(name_of(knob));
            if (!free_.contains(knob) || !why_without_effect(setting, cheapest_->settings, 0).empty()) continue;
            const std::vector<std::string> leaf_sizes{"0", "2", "4", "8", "16"};
            for (const std::string& value : knob == Knob::LeafCells ? leaf_sizes : setting.choices) {
                Attempt attempt = *cheapest_;
                assign(attempt.settings, name_of(knob) + "=" + value);
                if (attempt.settings.contact == cheapest_->settings.contact) continue;
                if (!broad_phase_of(attempt.settings).search.none()) attempt = needs_.attempt(attempt.settings);
                const bool cheaper = attempt.qualifies() && is_cheaper(attempt, worth_it);
                note(attempt, cheaper ? "cheapest so far" : "not cheaper");
                if (cheaper) cheapest_ = attempt;
            }
        }
    }

    /// Times a configuration and the cheapest so far in turn, for a machine has faster and slower moments, and keeps
    /// the medians.
    /// @param part of the cheapest's cost that it must be below
    bool is_cheaper(Attempt& attempt, double part) {
        if (!cheapest_) return true;
        std::vector<double> costs, costs_of_cheapest;
        for (int i = 0; i < 3; ++i) {
            costs.push_back(run_to_horizon(attempt.settings).cost);
            costs_of_cheapest.push_back(run_to_horizon(cheapest_->settings).cost);
        }
        attempt.cost = quartiles_of(costs).median;
        cheapest_->cost = quartiles_of(costs_of_cheapest).median;
        return attempt.cost < part * cheapest_->cost;
    }

    /// All values of a knob, or the scene's own where it is not free.
    template <class Value>
    [[nodiscard]] std::vector<Value> tried(Knob knob, Value own, const std::vector<Value>& all) const {
        return free_.contains(knob) ? all : std::vector{own};
    }

    [[nodiscard]] double cost_of_cheapest() const { return cheapest_ ? cheapest_->cost : no_bound; }

    void note(const Attempt& attempt, const std::string& if_it_qualifies) {
        trail_(attempt, attempt.qualifies() ? if_it_qualifies : attempt.why);
        if (!attempt.qualifies() && (!nearest_ || attempt.miss < nearest_->miss)) nearest_ = attempt;
    }

    const Needs& needs_;
    const Trail& trail_;
    std::set<Knob> free_;
    std::optional<Attempt> cheapest_, nearest_;
};

}  // namespace

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
    scene.contact.search = {};
    return scene;
}

Attempt search(const Needs& needs, const Trail& trail) { return NeedsSearch(needs, trail).find(); }

void try_notches(const Needs& needs, const std::function<void(Knob, const Attempt&)>& note) {
    for (const Knob knob : ordered_knobs) {
        if (const auto less = one_notch_less(needs.scene(), knob)) note(knob, needs.attempt(*less));
    }
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
