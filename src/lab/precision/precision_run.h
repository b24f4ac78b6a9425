#pragma once

#include <memory>
#include <optional>
#include <span>

#include "drape/sim/simulation.h"
#include "lab/measure/timing.h"
#include "precision_scene.h"

namespace drape {

/// A scene on its way under one method: by the integrator alone, or where there is a ball through `Simulation`.
class PrecisionRun {
public:
    /// @param start where it begins if not at rest
    PrecisionRun(const PrecisionScene& scene, const IntegratorParameters& parameters,
                 const std::optional<ClothState>& start = {});

    SolveReport step(Real h);

    [[nodiscard]] const ClothModel& model() const;
    [[nodiscard]] const ClothState& state() const;

    /// False once a number is none, or the energy has risen as far as counts as diverged.
    [[nodiscard]] bool bounded() const;

private:
    ClothModel model_;
    ClothState state_;
    Kernels kernels_;
    double energy_to_fail_;
    std::unique_ptr<Integrator> integrator_;
    std::optional<Simulation> simulation_;
};

/// The steps to a horizon: `count` equal ones, or with a phase in (0, 1) one more, of which the first is cut to that
/// part and the last to the rest, so that what happens on the way falls elsewhere within a step [s].
std::vector<Real> steps_to(Real horizon, int count, Real phase = 0);

/// Where a run ends.
struct Finish {
    ClothState state;
    bool bounded;
    int inner_steps;  ///< of Dormand-Prince
};

Finish finish(const PrecisionScene& scene, const IntegratorParameters& parameters, std::span<const Real> steps,
              const std::optional<ClothState>& start = {});

/// CPU time of a simulated second [s/s], over runs of equal steps to the horizon after one that warms up. The first
/// step of each is left out: in it, methods set up what they keep.
Quartiles cost_of(const PrecisionScene& scene, const IntegratorParameters& parameters, int steps, int repeats);

}  // namespace drape
