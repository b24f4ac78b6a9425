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

double longest_step_of_explicit_euler(double k, double d);
double longest_step_of_symplectic_euler(double k, double d);
double longest_step_of_velocity_verlet(double k, double d);
double longest_step_of_rk4(double k, double d);

/// Each is made with scratch arrays for a grid; where a function makes two kinds, the parameters say which.

std::unique_ptr<Integrator> make_euler(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_velocity_verlet(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_rk4(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_theta_method(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_bdf2(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_xpbd(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_projective_dynamics(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_dormand_prince(const IntegratorParameters& parameters, const Grid& grid);

}  // namespace drape
