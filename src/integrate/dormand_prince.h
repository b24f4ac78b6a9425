#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drape/integrate/integrator.h"
#include "drape/model/force_sweep.h"

namespace drape {

/// Runge-Kutta of order 5 with inner steps as short as an error estimate of order 4 asks for. The estimate is the
/// largest error of an x and h times that of a v, with h the whole step, and may be `tolerance` times the cloth's
/// spacing in each inner step. The first inner step tried is the whole one, so that nothing is remembered between
/// steps. One of `shortest` of it is taken whatever its error, and counted as unconverged. A step that is not through
/// after `max_inner_steps` of them is given up.
/// @cite dormand1980
class DormandPrince final : public Integrator {
public:
    DormandPrince(const IntegratorParameters& parameters, const Grid& grid)
        : tolerance_(tolerance_of(parameters)),
          forces_(grid, parameters.kernels),
          tried_{Points(grid.particles(), 3), Points(grid.particles(), 3)} {
        derivatives_.fill(tried_);
        error_ = tried_;
    }

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        const Real shortest = Real(1e-4) * h;
        const Real allowed = tolerance_ * std::min(model.hx, model.hy);
        SolveReport report;
        differentiate(model, state, derivatives_.front());
        report.force_evaluations = 1;
        report.tolerance = tolerance_;
        Real inner = h, remaining = h;
        for (int tried = 0; remaining > 0; ++tried) {
            if (tried == max_inner_steps) {
                report.gave_up = true;
                break;
            }
            // The rest of the step in equal parts, so that the last one is no sliver. Rounding may make them longer
            // than was asked for: what asked for the shortest is no longer than it.
            const bool is_shortest = inner <= shortest;
            const Real parts = std::ceil(remaining / inner);
            inner = remaining / parts;
            advance(model, state, inner);
            report.force_evaluations += stages - 1;
            const Real error = estimate(inner, h) / allowed;
            if (error <= 1 || is_shortest || inner <= shortest) {
                take(state, error, report);
                remaining = parts > 1 ? remaining - inner : 0;
                if (!std::isfinite(error)) break;
            }
            inner = std::max(inner * change_of_step(error), shortest);
        }
        return report;
    }

private:
    static constexpr int stages = 7;

    /// The Butcher tableau. Row i: the weights of the derivatives 0..i-1 in the point at which derivative i is taken.
    /// The last row is the method of order 5 itself, so that its derivative serves as the first of the next step.
    static constexpr double tableau[stages][stages - 1] = {
        {},
        {1. / 5},
        {3. / 40, 9. / 40},
        {44. / 45, -56. / 15, 32. / 9},
        {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
        {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
        {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};

    /// The method of order 5 less that of order 4.
    static constexpr double difference[stages] = {71. / 57600,      0,         -71. / 16695, 71. / 1920,
                                                  -17253. / 339200, 22. / 525, -1. / 40};

    /// The fifth root of a positive number, by Newton's method from the fourth root. Square roots have the same bits on
    /// every processor, std::pow has not.
    static Real fifth_root(Real a) {
        Real root = std::sqrt(std::sqrt(a));
        for (int iteration = 0; iteration < 5; ++iteration) {
            const Real square = root * root;
            root = (4 * root + a / (square * square)) / 5;
        }
        return root;
    }

    /// The inner step that was tried becomes the state; its last derivative is the first of the next.
    void take(ClothState& state, Real error, SolveReport& report) {
        std::swap(state, tried_);
        std::swap(derivatives_.front(), derivatives_.back());
        ++report.iterations;
        report += {.residual = error * tolerance_, .unconverged = error <= 1 ? 0 : 1};
    }

    /// dx/dt and dv/dt of a state.
    void differentiate(const ClothModel& model, const ClothState& state, ClothState& derivative) {
        derivative.x = state.v;
        forces_(model, state.x, state.v, [&](const ForceRun& run) { run.of(derivative.v) = run.accelerations(); });
    }

    /// What the next inner step may be, of this one: its error grows with the fifth power. A little less than that, and
    /// within what an estimate can be trusted for.
    static Real change_of_step(Real error) {
        constexpr Real caution = Real(0.9), least = Real(0.1), most = 5;
        if (!(error < Real(1e5))) return least;
        return std::clamp(caution / fifth_root(std::max(error, Real(1e-5))), least, most);
    }

    /// tried_ = one inner step of length s from the state, and all derivatives on the way.
    void advance(const ClothModel& model, const ClothState& state, Real s) {
        for (std::size_t stage = 1; stage < stages; ++stage) {
            tried_ = state;
            for (std::size_t k = 0; k < stage; ++k) {
                const Real weight = s * static_cast<Real>(tableau[stage][k]);
                tried_.x += weight * derivatives_[k].x;
                tried_.v += weight * derivatives_[k].v;
            }
            differentiate(model, tried_, derivatives_[stage]);
        }
    }

    /// The estimated error of an inner step of length s within the whole step h [m].
    Real estimate(Real s, Real h) {
        error_.x.setZero();
        error_.v.setZero();
        for (std::size_t k = 0; k < stages; ++k) {
            error_.x += static_cast<Real>(difference[k]) * derivatives_[k].x;
            error_.v += static_cast<Real>(difference[k]) * derivatives_[k].v;
        }
        const Real of_x = error_.x.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
        const Real of_v = error_.v.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
        return s * (of_x + h * of_v);
    }

    Real tolerance_;
    ForceSweep forces_;
    std::array<ClothState, stages> derivatives_;
    ClothState error_, tried_;
};

}  // namespace drape
