#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drape/integrate/integrator.h"
#include "support/cloths.h"

namespace drape::test {

/// The state after a number of equal steps.
inline ClothState after(const IntegratorParameters& parameters, const ClothModel& model, ClothState state, Real time,
                        int steps) {
    const auto integrator = make_integrator(parameters, model.grid);
    for (int step = 0; step < steps; ++step) integrator->step(model, state, time / steps);
    return state;
}

/// A small damped sheet, hung by two corners and plucked: smooth, and with every force in it.
struct Sheet {
    ClothParameters parameters;
    ClothModel model;
    ClothState start;

    explicit Sheet(Grid grid = {5, 4}) {
        parameters.particles = grid;
        parameters.mass = Real(0.5);
        parameters.pinned.kind = Pins::Kind::Two;
        parameters.structural = {60, Real(0.05)};
        parameters.shear = {30, Real(0.05)};
        parameters.bend = {10, Real(0.05)};
        parameters.drag = Real(1e-2);
        model = make_cloth_model(parameters);
        std::mt19937 random(4);
        start = random_state(parameters, random);
        for (int p = 0; p < parameters.particles.particles(); ++p) {
            if (model.pinned(p)) start.v.row(p).setZero();
        }
    }

    /// The same without spring damping and drag.
    void undamp() {
        parameters.structural.damping = parameters.shear.damping = parameters.bend.damping = parameters.drag = 0;
        model = make_cloth_model(parameters);
    }
};

/// Backward Euler, implicit midpoint and BDF2, each with both Hessians.
inline std::vector<IntegratorParameters> implicit_methods() {
    std::vector<IntegratorParameters> methods;
    for (const auto kind : {IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint, IntegratorKind::Bdf2}) {
        for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
            methods.push_back({.integrator = kind, .hessian = hessian});
        }
    }
    return methods;
}

/// Every method, the implicit ones with both Hessians.
inline std::vector<IntegratorParameters> all_methods() {
    std::vector<IntegratorParameters> methods = implicit_methods();
    for (const IntegratorKind kind : values_of<IntegratorKind>()) {
        const bool is_implicit = std::ranges::count(methods, kind, &IntegratorParameters::integrator) > 0;
        if (!is_implicit) methods.push_back({.integrator = kind});
    }
    return methods;
}

/// What a message says of a method.
inline std::string text_of(const IntegratorParameters& method) {
    return std::string(name_of(method.integrator)) + ", " + name_of(method.hessian);
}

/// The orders observed over two halvings of the step, against a far finer solution.
inline std::array<Real, 2> observed_orders(const IntegratorParameters& parameters) {
    static const Sheet sheet;
    constexpr Real horizon = Real(0.1);
    static const ClothState exact =
        after({.integrator = IntegratorKind::Rk4}, sheet.model, sheet.start, horizon, 20000);
    std::array<Real, 3> errors{};
    for (std::size_t halving = 0; halving < 3; ++halving) {
        const int steps = 100 << halving;
        errors[halving] = (after(parameters, sheet.model, sheet.start, horizon, steps).x - exact.x).norm();
    }
    return {std::log2(errors[0] / errors[1]), std::log2(errors[1] / errors[2])};
}

}  // namespace drape::test
