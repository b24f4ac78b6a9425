#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "drape/integrate/integrator.h"
#include "drape/scene/settings.h"

namespace drape {

/// An integrator with its variant, as tables and charts call it: "rk4", "bdf2_exact", "xpbd_20".
struct Method {
    std::string name;
    IntegratorParameters parameters;
};

/// @param names of an integrator, with "_clamped" or "_exact" behind it for the Hessian, or a number of iterations
std::vector<Method> methods_named(std::initializer_list<std::string> names);

/// A scene that is moved by a method: its kind, Hessian, iterations and tolerance.
Settings with_method(Settings scene, const IntegratorParameters& method);

}  // namespace drape
