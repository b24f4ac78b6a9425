#include "drape/session/unstable_mode.h"

#include <algorithm>
#include <numbers>

#include "drape/base/exact_math.h"
#include "drape/base/numbers.h"
#include "drape/model/stencils.h"

namespace drape {
namespace {

/// Marks the spring that takes the largest part. Its damper counts as well, as symplectic Euler has it: a mode is
/// unstable where the sum of h^2 k + 2 h c over its springs is more than 4, for displacements of norm 1 by mass.
void mark_spring(const ClothModel& model, const Points& x, Real h, UnstableMode& mode) {
    Real most = -1;
    for (const SpringStencil& springs : spring_stencils(model)) {
        const Real stiffness = springs.law.stiffness + 2 * springs.law.damping / h;
        springs.for_each(model.grid, [&](int a, int b) {
            const Vec3 along = x.row(a) - x.row(b), apart = mode.shape.row(a) - mode.shape.row(b);
            const Real lengthening = along.dot(apart) / along.norm(), energy = stiffness * lengthening * lengthening;
            if (energy > most) most = energy, mode.spring = {a, b}, mode.kind = springs.kind();
        });
    }
}

}  // namespace

std::optional<UnstableMode> find_unstable_mode(const Simulation& diverged, const Simulation& before) {
    const SolverSettings& solver = diverged.settings().solver;
    // Substeps are below the limit, unless the step is too long to be divided
    if (solver.on_unstable == OnUnstable::Substep && !(diverged.report().step_limit_ratio > 1)) return {};
    UnstableMode found{.step = solver.dt, .time = before.report().time};
    auto shortest = static_cast<Real>(solver.dt);
    for (std::size_t c = 0; c < diverged.cloths().size(); ++c) {
        const ClothModel& model = diverged.cloths()[c].model;
        const Points& x = before.cloths()[c].state.x;
        LimitingMode mode = limiting_mode(model, before.cloths()[c].state, solver.integrator, solver.kernels);
        if (!(mode.limit.step < shortest) || mode.shape.isZero(0)) continue;
        shortest = mode.limit.step;
        found.cloth = c;
        found.limit = mode.limit;
        found.shape = mode.shape / mode.shape.rowwise().norm().maxCoeff();
        mark_spring(model, x, static_cast<Real>(solver.dt), found);
    }
    if (found.shape.size() == 0) return {};
    return found;
}

std::string text_of(const UnstableMode& mode, bool with_limit) {
    const auto milliseconds = [](double seconds) { return real_text(1e3 * seconds, 3) + " ms"; };
    const auto limit = static_cast<double>(mode.limit.step);
    const std::string limit_text =
        limit > 0 ? "Its limit is " + std::string(mode.limit.at_least ? "at least " : "") + milliseconds(limit)
                  : "No step is stable";
    return "Shape of the unstable mode, " +
           real_text(static_cast<double>(mode.limit.omega) / (2 * std::numbers::pi), 3) +
           " Hz, on the cloth as it was at t = " + real_text(mode.time, 3) +
           " s, shown at 1 Hz and not to scale. Red: the " + std::string(mode.kind) +
           " spring with the largest part in it" +
           (with_limit ? ". " + limit_text + ", the time step was " + milliseconds(mode.step) : "");
}

bool is_calm(const Simulation& simulation) {
    constexpr Real calm = Real(0.05);
    Real largest = 0;
    for (const Cloth& cloth : simulation.cloths()) {
        for (const SpringStencil& springs : spring_stencils(cloth.model)) {
            springs.for_each(cloth.model.grid, [&](int a, int b) {
                const Vec3 parting = cloth.state.v.row(a) - cloth.state.v.row(b);
                largest = std::max(largest, parting.norm() / springs.rest_length);
            });
        }
    }
    return largest * static_cast<Real>(simulation.settings().solver.dt) <= calm;
}

void Swing::show(FrameView& view) {
    const FrameView calm = before_.view();
    cloths_.clear();
    for (const ClothView& cloth : calm.cloths) {
        const bool swings = cloths_.size() == mode_.cloth;
        if (swings) {
            const Real size = amplitude * std::min(cloth.model.hx, cloth.model.hy);
            x_ = cloth.x + size * static_cast<Real>(sine(2 * std::numbers::pi * frequency * time_)) * mode_.shape;
        }
        const Points& x = swings ? x_ : cloth.x;
        cloths_.push_back({cloth.model, x, x, {}, cloth.hierarchy, cloth.v, cloth.grabbed});
    }
    view.cloths = cloths_;
    view.balls = view.previous_balls = calm.balls;
    view.solids = view.previous_solids = calm.solids;
    view.mode = &mode_;
}

}  // namespace drape
