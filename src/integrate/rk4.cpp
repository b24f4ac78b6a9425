#include "drape/model/force_sweep.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// The classical Runge-Kutta method of order 4 on y = (x, v), y' = (v, a(x, v)).
class Rk4 final : public Integrator {
public:
    Rk4(const Grid& grid, int threads)
        : forces_(grid, threads),
          x_(grid.particles(), 3),
          v_(grid.particles(), 3),
          x_sum_(grid.particles(), 3),
          v_sum_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        x_ = state.x;
        v_ = state.v;
        x_sum_.setZero();
        v_sum_.setZero();
        stage(model, state, 1, h / 2);
        stage(model, state, 2, h / 2);
        stage(model, state, 2, h);
        stage(model, state, 1, 0);
        state.x += (h / 6) * x_sum_;
        state.v += (h / 6) * v_sum_;
        return {.force_evaluations = 4};
    }

private:
    /// Adds the slope at (x_, v_) with its weight, and moves (x_, v_) to `reach` along that slope from the start.
    void stage(const ClothModel& model, const ClothState& start, Real weight, Real reach) {
        forces_(model, x_, v_, [&](const ForceRun& run) {
            for (int axis = 0; axis < 3; ++axis) {
                run.of(x_sum_, axis) += weight * run.of(v_, axis);
                run.of(v_sum_, axis) += weight * run.accelerations(axis);
                run.of(x_, axis) = run.of(start.x, axis) + reach * run.of(v_, axis);
                run.of(v_, axis) = run.of(start.v, axis) + reach * run.accelerations(axis);
            }
        });
    }

    ForceSweep forces_;
    Points x_, v_, x_sum_, v_sum_;
};

}  // namespace

std::unique_ptr<Integrator> make_rk4(const Grid& grid, int threads) { return std::make_unique<Rk4>(grid, threads); }

}  // namespace drape
