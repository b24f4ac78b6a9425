#include "drape/integrate/stability.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape {
namespace {

using Pair = Eigen::Vector2d;
using Matrix = Eigen::Matrix2d;
using Step = Eigen::Matrix4d;  // of the states (x, v) of one wave, both in the cloth's plane

/// One step of a wave that moves as s' = rate s, as the integrators make it.
Step step_of(IntegratorKind kind, const Step& rate, double h) {
    const Step same = Step::Identity();
    Step drift = Step::Zero(), kick = Step::Zero();
    drift.topRows<2>() = h * rate.topRows<2>();
    kick.bottomRows<2>() = h * rate.bottomRows<2>();
    switch (kind) {
        case IntegratorKind::ExplicitEuler:
            return same + h * rate;
        case IntegratorKind::SymplecticEuler:
            return (same + drift) * (same + kick);
        case IntegratorKind::VelocityVerlet: {
            // The second force sees x_{n+1} = x + h v + h^2/2 a and v + h a
            const Step moved = same + drift + drift * kick / 2;
            return moved + kick / 2 + kick / 2 * (moved + kick);
        }
        case IntegratorKind::Rk4: {
            const Step z = h * rate;
            return same + z * (same + z / 2 * (same + z / 3 * (same + z / 4)));
        }
    }
    return same;
}

double longest_step(IntegratorKind kind, const Step& rate, double highest_frequency) {
    constexpr double rounding = 1e-6;
    double stable = 0, unstable = 4 / highest_frequency;  // no explicit method here reaches three
    for (int bisection = 0; bisection < 20; ++bisection) {
        const double middle = (stable + unstable) / 2;
        const bool bounded = step_of(kind, rate, middle).eigenvalues().cwiseAbs().maxCoeff() <= 1 + rounding;
        (bounded ? stable : unstable) = middle;
    }
    return stable;
}

/// Stiffness and damping against a plane wave, as 2 x 2 matrices over the directions in the plane.
struct Response {
    Matrix stiffness = Matrix::Zero();
    Matrix damping = Matrix::Zero();

    /// Adds the springs that join each particle with the one at (di, dj), seen by a wave of given phase a column and
    /// row.
    void add(const ClothModel& model, const SpringLaw& law, int di, int dj, const Pair& phase) {
        const Pair reach(di * static_cast<double>(model.hx), dj * static_cast<double>(model.hy));
        const Matrix along = reach * reach.transpose() / reach.squaredNorm();
        const double bent = 2 * (1 - std::cos(di * phase[0] + dj * phase[1]));
        stiffness += static_cast<double>(law.stiffness) * bent * along;
        damping += static_cast<double>(law.damping) * bent * along;
    }
};

Response response_to(const ClothModel& model, const Pair& phase) {
    Response response;
    response.add(model, model.structural, 1, 0, phase);
    response.add(model, model.structural, 0, 1, phase);
    response.add(model, model.shear, 1, 1, phase);
    response.add(model, model.shear, -1, 1, phase);
    response.add(model, model.bend, 2, 0, phase);
    response.add(model, model.bend, 0, 2, phase);
    return response;
}

}  // namespace

Real estimated_stable_step(const ClothModel& model, IntegratorKind kind) {
    constexpr int samples = 12;  // of the phase, from 0 to pi
    constexpr double turn = std::numbers::pi / samples;
    const auto mass = static_cast<double>(model.particle_mass), drag = static_cast<double>(model.drag);
    double limit = std::numeric_limits<double>::infinity();
    for (int j = -samples; j <= samples; ++j) {
        for (int i = 0; i <= samples; ++i) {
            const Response response = response_to(model, {turn * i, turn * j});
            const double highest = std::sqrt(response.stiffness.norm() / mass);
            if (!(highest > 0)) continue;
            Step rate = Step::Zero();
            rate.topRightCorner<2, 2>().setIdentity();
            rate.bottomLeftCorner<2, 2>() = -response.stiffness / mass;
            rate.bottomRightCorner<2, 2>() = -(response.damping + drag * Matrix::Identity()) / mass;
            limit = std::min(limit, longest_step(kind, rate, highest));
        }
    }
    return static_cast<Real>(limit);
}

}  // namespace drape
