#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "drape/base/assert.h"
#include "drape/base/numbers.h"
#include "drape/integrate/integrator.h"
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
        Method& method = methods.emplace_back(Method{name, {.kind = *kind}});
        if (hessian) method.parameters.hessian = *hessian;
        if (iterations) method.parameters.iterations = static_cast<int>(*iterations);
    }
    return methods;
}

/// A scene that is moved by a method: its kind, Hessian, iterations and tolerance.
inline Settings with_method(Settings scene, const IntegratorParameters& method) {
    scene.solver.integrator = method.kind;
    scene.solver.hessian = method.hessian;
    scene.solver.iterations = method.iterations;
    scene.solver.tolerance = method.tolerance;
    return scene;
}

}  // namespace drape
