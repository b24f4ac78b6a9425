#include <algorithm>
#include <utility>

#include "divergence.h"
#include "drape/base/numbers.h"
#include "drape/integrate/stability.h"
#include "drape/sim/simulation.h"

namespace drape {

/// Ends the run where it has lost a cloth or a step could not be made, and marks what is in doubt. Only under
/// `on_unstable = stop` does a doubt end it.
void Simulation::check_cloths(Real h) {
    const SolverSettings& solver = settings_.solver;
    const bool stops = solver.on_unstable == OnUnstable::Stop;
    const SolveReport& solve = report_.solve;
    const auto residual = static_cast<double>(solve.residual);
    if (!(residual <= report_.worst_residual)) report_.worst_residual = residual;
    if (solve.gave_up) return end_with(solve_trouble());

    // An explicit step costs little more than the sum over the springs
    const int least_pause = has_step_limit(solver.integrator) ? 32 : 1;
    bool heated = false;
    for (Cloth& cloth : cloths_) {
        const MotionSums sums = sum_motion(cloth.state);
        const std::string trouble = divergence(cloth, sums, balls_, settings_);
        if (!trouble.empty()) {
            return end_with(trouble + " in step " + std::to_string(report_.step + 1) + " of " +
                            std::string(name_of(solver.integrator)));
        }
        cloth.energy_watch.look(cloth.model, cloth.state, sums, h, least_pause);
        report_.energy_excess = std::max(report_.energy_excess, cloth.energy_watch.excess());
        if (!cloth.energy_watch.heated()) continue;
        heated = true;
        if (report_.heated_step > 0) continue;
        report_.heated_step = report_.step + 1;
        report_.heated_by = solver.integrator;
    }
    if (stops && solve.unconverged > 0) return end_with(solve_trouble());
    if (stops && heated) end_with(heat_trouble());
}

std::string Simulation::solve_trouble() const {
    const SolveReport& solve = report_.solve;
    const std::string method(name_of(settings_.solver.integrator)), step = " step " + std::to_string(report_.step + 1);
    const std::string tolerance = "tolerance " + real_text(static_cast<double>(solve.tolerance), 3);
    if (solve.gave_up) {
        return method + " is not through" + step + " after " + std::to_string(most_inner_steps) +
               " inner steps, taken and rejected, at " + tolerance + "; a shorter solver.dt needs fewer";
    }
    return method + " has not solved" + step + ": residual " + real_text(static_cast<double>(solve.residual), 3) +
           ", " + tolerance;
}

std::string Simulation::heat_trouble() const {
    return std::string(name_of(report_.heated_by)) + " has made " + real_text(report_.energy_excess, 3) +
           " J more mechanical energy than hand, balls and wind can have put in, seen first in step " +
           std::to_string(report_.heated_step);
}

std::string Simulation::run_warning() const {
    std::string text;
    if (report_.unconverged > 0) {
        text = std::string(name_of(report_.unsolved_by)) + " has not solved " + std::to_string(report_.unconverged) +
               " of " + std::to_string(report_.step) + " steps to its tolerance, largest residual " +
               real_text(report_.worst_residual, 3);
    }
    if (report_.heated_step > 0) text += (text.empty() ? "" : "; ") + heat_trouble();
    return text;
}

/// The last good state stays on show.
void Simulation::end_with(std::string trouble) {
    report_.trouble = std::move(trouble);
    report_.status = Status::Diverged;
    steps_wanted_ = 0;
    for (Cloth& cloth : cloths_) {
        cloth.state = cloth.previous;
        cloth.contacts.clear();
        if (cloth.ledger) cloth.ledger->return_to_mark();
    }
    balls_ = previous_balls_;
}

}  // namespace drape
