#include "drape/model/forces.h"
#include "explicit_methods.h"

namespace drape {
namespace {

/// The classical Runge-Kutta method of order 4 on y = (x, v), y' = (v, a(x, v)).
class Rk4 final : public Integrator {
public:
    explicit Rk4(int particles)
        : x_(particles, 3), v_(particles, 3), a_(particles, 3), x_sum_(particles, 3), v_sum_(particles, 3) {}

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
        compute_forces(model, x_, v_, a_);
        forces_to_accelerations(model, a_);
        x_sum_ += weight * v_;
        v_sum_ += weight * a_;
        x_ = start.x + reach * v_;
        v_ = start.v + reach * a_;
    }

    Points x_, v_, a_, x_sum_, v_sum_;
};

}  // namespace

std::unique_ptr<Integrator> make_rk4(int particles) { return std::make_unique<Rk4>(particles); }

}  // namespace drape
