#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "drape/model/cloth_model.h"

namespace drape {

/// The time integrators; names as in settings and files.
enum class IntegratorKind { ExplicitEuler, SymplecticEuler, VelocityVerlet, Rk4 };

/// What an integrator tells about one step.
struct SolveReport {
    int force_evaluations = 0;
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

/// @param particles of the cloths it will step; the scratch arrays are made here
std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, int particles);

/// The names of all kinds, in the order of the enumeration.
std::span<const std::string> integrator_names();

std::string_view name_of(IntegratorKind kind);

}  // namespace drape
