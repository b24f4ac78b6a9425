#pragma once

#include <cmath>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "drape/base/assert.h"
#include "drape/base/exact_math.h"
#include "drape/base/numbers.h"
#include "drape/integrate/integrator.h"
#include "drape/model/cloth_model.h"
#include "drape/scene/settings.h"

namespace drape {

/// An integrator with its variant, as tables and charts call it: "rk4", "bdf2_exact", "xpbd_20".
struct Method {
    std::string name;
    IntegratorParameters parameters;
};

/// @param names of an integrator, with "_clamped" or "_exact" behind it for the Hessian, or a number of iterations
inline std::vector<Method> methods_named(std::initializer_list<std::string> names) {
    std::vector<Method> methods;
    for (const std::string& name : names) {
        const std::size_t end = name.find_last_of('_');
        const std::string variant = end == std::string::npos ? "" : name.substr(end + 1);
        const auto iterations = parse_integer(variant);
        const auto hessian = value_named<Hessian>(variant);
        const auto kind = value_named<IntegratorKind>(iterations || hessian ? name.substr(0, end) : name);
        DRAPE_ASSERT(kind.has_value());
        Method& method = methods.emplace_back(Method{name, {.integrator = *kind}});
        if (hessian) method.parameters.hessian = *hessian;
        if (iterations) method.parameters.iterations = static_cast<int>(*iterations);
    }
    return methods;
}

/// A scene that is moved by a method.
inline Settings with_method(Settings scene, const IntegratorParameters& method) {
    static_cast<IntegratorParameters&>(scene.solver) = method;
    return scene;
}

/// A sheet of 1 m on which methods are compared. The drag on all of it takes a tenth of its speed in 0.04 s.
/// @param side particles along each
/// @param stiffness, damping of the structural springs
inline ClothParameters sheet_of(int side, Real stiffness, Real damping) {
    constexpr Real whole_drag = Real(0.5);  // N s/m
    ClothParameters cloth;
    cloth.particles = {side, side};
    cloth.structural = {stiffness, damping};
    cloth.shear = {stiffness / 2, damping};
    cloth.bend = {stiffness / 10, damping};
    cloth.drag = whole_drag / static_cast<Real>(cloth.particles.particles());
    return cloth;
}

/// An error at the start of a motion, as root mean square over the free particles [m]: small against any motion, large
/// against rounding.
constexpr Real small_error = sizeof(Real) == sizeof(double) ? Real(1e-9) : Real(1e-4);

/// An error that grows more than this on the way to a horizon makes positions there a matter of luck.
constexpr double most_growth = 50;

/// A state with that error in every free coordinate, the same each time: symmetry would hide what grows.
inline ClothState disturbed(const ClothModel& model, ClothState state) {
    std::mt19937 random(1);
    Points error = Points::Zero(state.x.rows(), 3);
    int free = 0;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) continue;
        ++free;
        for (int axis = 0; axis < 3; ++axis) error(p, axis) = uniform<Real>(random);
    }
    state.x += error * (small_error * std::sqrt(static_cast<Real>(free)) / error.norm());
    return state;
}

/// Root mean square distance of the particles [m].
inline double position_error(const Points& x, const Points& exact) {
    return std::sqrt(static_cast<double>((x - exact).squaredNorm()) / static_cast<double>(x.rows()));
}

}  // namespace drape
