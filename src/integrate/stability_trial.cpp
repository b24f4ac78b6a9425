#include "drape/integrate/stability_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "drape/base/exact_math.h"
#include "drape/integrate/stability.h"
#include "drape/model/energy.h"

namespace drape {
namespace {

Real diagonal(const ClothModel& model) {
    return std::sqrt(model.width() * model.width() + model.height() * model.height());
}

/// Displaces every free coordinate by up to a millionth of the cloth's spacing.
void add_noise(const ClothModel& model, ClothState& state) {
    std::mt19937 random(1);
    const Real size = Real(1e-6) * std::min(model.hx, model.hy);
    for (int p = 0; p < model.grid.particles(); ++p) {
        for (int axis = 0; axis < 3; ++axis) {
            const Real noise = size * uniform<Real>(random);
            if (!model.pinned(p)) state.x(p, axis) += noise;
        }
    }
}

}  // namespace

Real energy_to_fail(const ClothModel& model) {
    constexpr Real gravity = Real(9.81);
    return model.particle_mass * static_cast<Real>(model.grid.particles()) * gravity * diagonal(model);
}

TrialEnd try_step(const ClothModel& model, ClothState start, const IntegratorParameters& parameters, Real step,
                  int steps) {
    constexpr int between_looks = 25;
    const Points home = start.x;
    const double most = static_cast<double>(energy_to_fail(model)),
                 limit = compute_energy(model, start, parameters.kernels).total() + most;
    const Real reach = 2 * diagonal(model);
    add_noise(model, start);
    const auto integrator = make_integrator(parameters, model.grid);
    bool rose = false;
    for (int n = 1; n <= steps; ++n) {
        integrator->step(model, start, step);
        if (n % between_looks != 0 && n != steps) continue;
        const Energy energy = compute_energy(model, start, parameters.kernels);
        if (!std::isfinite(energy.total()) || !start.x.allFinite()) return TrialEnd::NotFinite;
        rose = rose || energy.total() > limit;
        if (rose && energy.kinetic > most) return TrialEnd::EnergyRose;
        if ((start.x - home).rowwise().squaredNorm().maxCoeff() > reach * reach) return TrialEnd::OutOfReach;
    }
    return rose ? TrialEnd::Stretched : TrialEnd::Bounded;
}

Real measured_limit(const ClothModel& model, const ClothState& start, const IntegratorParameters& parameters,
                    Real guess, int steps, const std::function<void(Real, TrialEnd)>& tried) {
    constexpr Real precision = Real(0.005), longest = 1;
    constexpr int most_halvings = 20;
    const auto bounded = [&](Real step) {
        const TrialEnd end = try_step(model, start, parameters, step, steps);
        if (tried) tried(step, end);
        return end == TrialEnd::Bounded;
    };

    // One step that stays bounded, and one that does not
    Real stable = guess > 0 ? std::min(guess, longest) : longest, unstable = 0;
    for (int halving = 0; !bounded(stable); ++halving) {
        if (halving == most_halvings) return 0;
        unstable = stable;
        stable /= 2;
    }
    while (unstable == 0) {
        if (stable >= longest) return std::numeric_limits<Real>::infinity();
        const Real next = std::min(2 * stable, longest);
        (bounded(next) ? stable : unstable) = next;
    }
    while (unstable > (1 + precision) * stable) {
        const Real middle = std::sqrt(stable * unstable);
        (bounded(middle) ? stable : unstable) = middle;
    }
    return std::sqrt(stable * unstable);
}

Real observable_limit_of_explicit_euler(const ClothModel& model, const ClothState& start, Real omega, Real zeta,
                                        Kernels kernels, int steps) {
    const Real k = omega * omega, d = 2 * zeta * omega;
    if (zeta > 1) {
        const IntegratorKind kind = IntegratorKind::ExplicitEuler;
        return static_cast<Real>(longest_step(kind, static_cast<double>(k), static_cast<double>(d)));
    }
    ClothState noisy = start;
    add_noise(model, noisy);
    const double noise = compute_energy(model, noisy, kernels).spring - compute_energy(model, start, kernels).spring;
    const double gain = static_cast<double>(energy_to_fail(model)) / noise;
    const auto growth = static_cast<Real>(exponential(natural_log(gain) / steps) - 1);
    return (d + std::sqrt(d * d + 4 * k * growth)) / (2 * k);
}

}  // namespace drape
