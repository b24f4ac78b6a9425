#include "newton_system.h"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

/// Up to so many particles factors come first: they cost a fraction of a millisecond and solve to rounding. Iterations
/// are quicker at any size, by 1.5 times for springs of 1e6 N/m at 1/20 s up to forty for gentle steps.
constexpr int few_particles = 64;

bool comes_first(const Grid& grid) { return grid.particles() <= few_particles; }

/// Where there are no factors to fall back on, a solve ends after so many iterations with what it has.
constexpr int most_iterations = 5000;

/// Where there are, it ends after about half of what the factors cost, which grows with n^1.5 as n^0.5 iterations do.
int patience(int particles) { return static_cast<int>(8 * std::sqrt(static_cast<Real>(particles))); }

/// From so many particles on there is multigrid, and it is used for systems whose condition's root is at least this.
/// With the diagonal blocks alone about twice as many iterations are needed, and 60 take as long as four with cycles
/// and their set-up. Measured at 32 to 128 particles a side.
constexpr int many_particles = 400;
constexpr Real stiff = 30;

/// Where so many cycles do not do, single precision is not enough, and the diagonal blocks are left to it.
constexpr int most_cycles = 100;

/// How many times the cloth's momentum the force ahead may change it by, both without what all particles share. Beyond
/// some of this, stiff sheets gain energy in long steps. Midpoint damps nothing, not even what a bad beginning leaves.
Real max_momentum_change(IntegratorKind kind) { return kind == IntegratorKind::ImplicitMidpoint ? 2 : 8; }

/// How far some vectors of the free particles are from their mean: the root of the sum of squares.
Real spread(const ClothModel& model, const Points& vectors) {
    Vec3 sum = Vec3::Zero();
    Real squares = 0;
    int count = 0;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) continue;
        const Vec3 one = vectors.row(p);
        sum += one;
        squares += one.squaredNorm();
        ++count;
    }
    return std::sqrt(std::max(squares - sum.squaredNorm() / static_cast<Real>(std::max(count, 1)), Real(0)));
}

/// Of a Newton step, that is tried before it is given up.
constexpr Real shortest_part = Real(0.05);

/// With factors few iterations are needed, or many do not help.
constexpr int refinements = 50;

}  // namespace

NewtonSystem::NewtonSystem(const Grid& grid, const IntegratorParameters& parameters)
    : tolerance_(tolerance_of(parameters)),
      newton_steps_(parameters.newton_steps),
      max_momentum_change_(max_momentum_change(parameters.kind)),
      factors_first_(comes_first(grid)),
      jacobian_(grid, parameters.hessian, parameters.kernels),
      inverse_(grid.particles(), 6),
      x_(grid.particles(), 3),
      conjugate_gradients_(grid.particles()) {
    pinned_.reserve(static_cast<std::size_t>(grid.particles()));
    if (parameters.hessian == Hessian::Exact) bicgstab_ = std::make_unique<krylov::BiCgStab>(grid.particles());
    if (keeps_factors(grid, parameters.hessian)) factor_ = std::make_unique<GridFactor>(grid);
    if (refines()) {
        for (Points* scratch : {&left_, &step_, &tried_, &v_}) scratch->resize(grid.particles(), 3);
    }
    if (keeps_multigrid(grid, parameters.hessian)) multigrid_ = std::make_unique<Multigrid>(grid, parameters.kernels);
}

bool NewtonSystem::keeps_multigrid(const Grid& grid, Hessian hessian) {
    return hessian == Hessian::Clamped && grid.particles() >= many_particles;
}

/// The matrix is between its inertia and what four springs of each kind at both ends add to that.
bool NewtonSystem::is_stiff(const ClothModel& model, Real s) const {
    Real springs = 0;
    for (const SpringLaw& law : {model.structural, model.shear, model.bend}) {
        springs += 8 * (s * s * law.stiffness + s * law.damping);
    }
    return springs > stiff * stiff * (model.particle_mass + s * jacobian_.drag());
}

bool NewtonSystem::keeps_factors(const Grid& grid, Hessian hessian) {
    const bool falls_back = hessian == Hessian::Exact && grid.particles() <= GridFactor::largest;
    return comes_first(grid) || falls_back;
}

int NewtonSystem::linearise_ahead(ForceSweep& forces, const ClothModel& model, const ClothState& state,
                                  const Points& dx, Real s, Points& f) {
    pinned_.clear();
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) pinned_.push_back(p);
    }
    x_ = state.x + dx;
    forces.compute(model, x_, state.v, f);
    clear_pinned(f);
    if (s * spread(model, f) <= max_momentum_change_ * model.particle_mass * spread(model, state.v)) {
        jacobian_.linearise(model, x_, state.v);
        return 1;
    }
    forces.compute(model, state.x, state.v, f);
    jacobian_.linearise(model, state.x, state.v);
    jacobian_.add_product(-1, 0, dx, f);
    clear_pinned(f);
    return 2;
}

void NewtonSystem::clear_pinned(Points& points) const {
    for (const int p : pinned_) points.row(p).setZero();
}

void NewtonSystem::invert_diagonal(const ClothModel& model, Real s) {
    const Real own = model.particle_mass + s * jacobian_.drag();
    inverse_.leftCols<1>().setConstant(own);
    inverse_.rightCols<5>().setZero();
    inverse_.col(3).setConstant(own);
    inverse_.col(5).setConstant(own);
    jacobian_.for_each_block(s * s, s, [&](int a, int b, const Jacobian::Block& block) {
        if (a != b) return;
        inverse_(a, 0) += block(0, 0), inverse_(a, 1) += block(0, 1), inverse_(a, 2) += block(0, 2);
        inverse_(a, 3) += block(1, 1), inverse_(a, 4) += block(1, 2), inverse_(a, 5) += block(2, 2);
    });
    for (Eigen::Index p = 0; p < inverse_.rows(); ++p) {
        const Real xx = inverse_(p, 0), xy = inverse_(p, 1), xz = inverse_(p, 2);
        const Real yy = inverse_(p, 3), yz = inverse_(p, 4), zz = inverse_(p, 5);
        const Real cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
        const Real scale = 1 / (xx * cxx + xy * cxy + xz * cxz);
        inverse_.row(p) << scale * cxx, scale * cxy, scale * cxz, scale * (xx * zz - xz * xz),
            scale * (xy * xz - xx * yz), scale * (xx * yy - xy * xy);
    }
    for (const int p : pinned_) inverse_.row(p).setZero();
}

void NewtonSystem::apply_inverse_diagonal(const Points& r, Points& z) const {
    const auto rx = r.col(0).array(), ry = r.col(1).array(), rz = r.col(2).array();
    z.col(0) = inverse_.col(0) * rx + inverse_.col(1) * ry + inverse_.col(2) * rz;
    z.col(1) = inverse_.col(1) * rx + inverse_.col(3) * ry + inverse_.col(4) * rz;
    z.col(2) = inverse_.col(2) * rx + inverse_.col(4) * ry + inverse_.col(5) * rz;
}

krylov::Outcome NewtonSystem::solve(const ClothModel& model, Real s, Points& r, Points& dv) {
    clear_pinned(r);
    const auto apply = [&](const Points& u, Points& y) {
        y = model.particle_mass * u;
        jacobian_.add_product(s * s, s, u, y);
        clear_pinned(y);
    };
    const auto solve_with = [&](int iterations, auto precondition) {
        const krylov::Limits limits{tolerance_, iterations};
        if (bicgstab_) return bicgstab_->solve(r, dv, limits, apply, precondition);
        return conjugate_gradients_.solve(r, dv, limits, apply, precondition);
    };
    krylov::Outcome outcome;
    if (multigrid_ && is_stiff(model, s)) {
        multigrid_->build(model, jacobian_, s * s, s);
        outcome = solve_with(most_cycles, [&](const Points& from, Points& to) { multigrid_->cycle(from, to); });
        if (outcome.converged) return outcome;
    }
    const int cycles = outcome.iterations;
    if (!factors_first_) {
        invert_diagonal(model, s);
        outcome = solve_with(factor_ ? patience(model.grid.particles()) : most_iterations,
                             [&](const Points& from, Points& to) { apply_inverse_diagonal(from, to); });
        outcome.iterations += cycles;
        if (!factor_ || outcome.converged) return outcome;
    }
    factor_->factorise(model, jacobian_, s * s, s);
    const int wasted = outcome.iterations;
    outcome = solve_with(refinements, [&](const Points& from, Points& to) { factor_->solve(from, to); });
    outcome.iterations += wasted;
    return outcome;
}

SolveReport NewtonSystem::refine(ForceSweep& forces, const ClothModel& model, const Points& x, const Points& v, Real s,
                                 Real theta, Points& dv) {
    SolveReport all;
    const auto left_at = [&](const Points& at) {
        x_ = x + (s * theta) * at;
        v_ = v + theta * at;
        forces.compute(model, x_, v_, left_);
        ++all.force_evaluations;
        left_ = (s / theta) * left_ - model.particle_mass * at;
        clear_pinned(left_);
        return left_.norm();
    };
    Real left = left_at(dv);
    for (int made = 1; made < newton_steps_; ++made) {
        jacobian_.linearise(model, x_, v_);
        all += report(0, solve(model, s, left_, step_));
        const Real before = left;
        Real part = 1;
        do {
            tried_ = dv + part * step_;
            left = left_at(tried_);
            part /= 2;
        } while (!(left < before) && part > shortest_part);
        if (!(left < before)) break;
        dv = tried_;
    }
    return all;
}

SolveReport NewtonSystem::report(int force_evaluations, const krylov::Outcome& solved) const {
    return {.force_evaluations = force_evaluations,
            .iterations = solved.iterations,
            .residual = solved.residual,
            .tolerance = tolerance_,
            .unconverged = solved.converged ? 0 : 1};
}

}  // namespace drape
