#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "drape/model/cloth_model.h"
#include "drape/model/jacobian.h"

namespace drape {

/// The time integrators; names as in settings and files.
enum class IntegratorKind {
    ExplicitEuler,
    SymplecticEuler,
    VelocityVerlet,
    Rk4,
    BackwardEuler,
    ImplicitMidpoint,
    Bdf2,
    Xpbd,
    ProjectiveDynamics,
    DormandPrince
};

/// What an integrator is made from; each reads what concerns it.
struct IntegratorParameters {
    IntegratorKind kind = IntegratorKind::VelocityVerlet;
    Hessian hessian = Hessian::Clamped;  ///< of backward Euler, implicit midpoint and BDF2
    int iterations = 10;                 ///< of XPBD and projective dynamics in one step
    Real tolerance = Real(1e-6);         ///< of Dormand-Prince: error of a step, of the cloth's spacing
    int threads = 1;                     ///< that share the work of the explicit methods; the result is the same
    bool operator==(const IntegratorParameters&) const = default;
};

/// What an integrator tells about one step.
struct SolveReport {
    int force_evaluations = 0;
    int iterations = 0;  ///< of conjugate gradients, XPBD, projective dynamics, or inner steps of Dormand-Prince
    Real residual = 0;   ///< of an implicit method's linear system, relative to its right side

    SolveReport& operator+=(const SolveReport& other) {
        force_evaluations += other.force_evaluations;
        iterations += other.iterations;
        residual = std::max(residual, other.residual);
        return *this;
    }
};

/// Advances a cloth by one step. The state is all it goes on from, so the kind can change between any two steps.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// @param state advanced in place; pinned particles keep their velocity (zero, or that of the hand that holds them)
    /// @param h step [s]
    /// @par Cost O(n), allocates nothing
    virtual SolveReport step(const ClothModel& model, ClothState& state, Real h) = 0;
};

/// @param grid of the cloths it will step; the scratch arrays are made here
std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid);

/// The names of all kinds, in the order of the enumeration.
std::span<const std::string> integrator_names();

std::string_view name_of(IntegratorKind kind);

/// The names of both, in the order of the enumeration.
std::span<const std::string> hessian_names();

}  // namespace drape
