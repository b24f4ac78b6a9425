#include "precision_methods.h"

namespace drape {

const std::vector<PrecisionMethod>& precision_methods() {
    using enum IntegratorKind;
    using enum Hessian;
    // Not far below its limit RK4 is as exact as the reference: its ladder starts farther above
    static const std::vector<PrecisionMethod> all{
        {"explicit_euler", "explicit Euler", {.kind = ExplicitEuler}, 0},
        {"symplectic_euler", "symplectic Euler", {.kind = SymplecticEuler}, 0},
        {"velocity_verlet", "velocity Verlet", {.kind = VelocityVerlet}, 0},
        {"rk4", "RK4", {.kind = Rk4}, 0, 4},
        {"dormand_prince", "Dormand-Prince", {.kind = DormandPrince}, 0},
        {"backward_euler", "backward Euler", {.kind = BackwardEuler}, 1},
        {"implicit_midpoint_clamped", "midpoint, clamped", {.kind = ImplicitMidpoint, .hessian = Clamped}, 1},
        {"implicit_midpoint_exact", "midpoint, exact", {.kind = ImplicitMidpoint, .hessian = Exact}, 1},
        {"bdf2_clamped", "BDF2, clamped", {.kind = Bdf2, .hessian = Clamped}, 1},
        {"bdf2_exact", "BDF2, exact", {.kind = Bdf2, .hessian = Exact}, 1},
        {"xpbd_1", "XPBD, 1 iteration", {.kind = Xpbd, .iterations = 1}, 2},
        {"xpbd_5", "XPBD, 5 iterations", {.kind = Xpbd, .iterations = 5}, 2},
        {"xpbd_20", "XPBD, 20 iterations", {.kind = Xpbd, .iterations = 20}, 2},
        {"projective_dynamics_5", "projective, 5 iterations", {.kind = ProjectiveDynamics, .iterations = 5}, 2},
        {"projective_dynamics_20", "projective, 20 iterations", {.kind = ProjectiveDynamics, .iterations = 20}, 2}};
    return all;
}

}  // namespace drape
