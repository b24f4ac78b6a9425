#include <gtest/gtest.h>

#include <cmath>

#include "drape/contact/response.h"

namespace drape {
namespace {

/// One spring that also pulls: x' = v, v' = -w^2 x - 2 zeta w v, force from the start of the step.
/// @param damping share of its velocity that the damper takes in a step
/// @return what it has grown to from 1e-4 m [m]
Real swing(Real w, Real damping, Real h) {
    Real x = Real(1e-4), v = 0;
    for (int step = 0; step < 2000; ++step) {
        v += -h * w * w * x - damping * v;
        x += h * v;
    }
    return std::abs(x) + std::abs(v) / w;
}

TEST(PenaltyStepLimit, IsWhereASwingOfTheSpringGrows) {
    constexpr Real stiffness = 1000, inverse_mass = 180;
    const Real w = std::sqrt(stiffness * inverse_mass), pi = std::acos(Real(-1));
    for (const Real restitution : {Real(1), Real(0.5), Real(0)}) {
        const Real decay = restitution > 0 ? -std::log(restitution) : 0;
        const Real zeta = restitution > 0 ? decay / std::sqrt(pi * pi + decay * decay) : 1;
        for (const Real part : {Real(0.95), Real(1.05)}) {
            const Real h = part * penalty_step_limit(stiffness, restitution, inverse_mass);
            EXPECT_EQ(swing(w, 2 * zeta * w * h, h) < 1e-3, part < 1) << restitution;
            // A damper that sees the mean of what was and what it leaves
            const Real longer = part * penalty_step_limit(stiffness, restitution, inverse_mass, Real(0.5));
            EXPECT_EQ(swing(w, 2 * zeta * w * longer / (1 + zeta * w * longer), longer) < 1e-3, part < 1)
                << restitution;
        }
    }
}

}  // namespace
}  // namespace drape
