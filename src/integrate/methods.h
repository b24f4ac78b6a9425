#pragma once

#include "drape/integrate/integrator.h"

namespace drape {

/// What a method keeps to solve with.
enum class Keeps { Nothing, NewtonSystem, ScalarFactors };

/// The longest step of a method for a vibration x'' = -k x - d x', where k and d are not both 0 [s].
/// @param k [1/s^2], d [1/s]
using LongestStep = double (*)(double k, double d);

/// All that has to be known of a kind of integrator: its row in the table of `method_of`.
struct MethodRow {
    std::unique_ptr<Integrator> (*make)(const IntegratorParameters& parameters, const Grid& grid);
    LongestStep longest_step = nullptr;  ///< null where no step is too long
    double displacement = 1;             ///< see `displacement_factor`
    double tolerance = 0;                ///< see `tolerance_of`; of a linear solve, with the clamped Hessian
    double numbers;                      ///< a particle, of the arrays that its class has: three for each of Points
    Keeps keeps = Keeps::Nothing;
    bool iterates = false;  ///< as many times as it is told
};

/// @par Cost constant
const MethodRow& method_of(IntegratorKind kind);

}  // namespace drape
