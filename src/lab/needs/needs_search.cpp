#include "needs.h"

#include "drape/scene/setting_table.h"
#include "lab/measure/statistics.h"

namespace drape {
namespace {

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

Attempt search(const Needs& needs, const Trail& trail) { return NeedsSearch(needs, trail).find(); }

void try_notches(const Needs& needs, const std::function<void(Knob, const Attempt&)>& note) {
    for (const Knob knob : ordered_knobs) {
        if (const auto less = one_notch_less(needs.scene(), knob)) note(knob, needs.attempt(*less));
    }
}

}  // namespace drape
