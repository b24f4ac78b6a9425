#include "newton_system.h"

#include <cmath>
#include <cstdlib>

namespace drape {
namespace {

/// Residuals are brought down to this part of the right side, well below what a step's own error is.
constexpr Real tolerance = sizeof(Real) == 8 ? Real(1e-6) : Real(1e-4);

/// Beyond this many iterations a solve ends with what it has, and says so by its residual.
constexpr int most_iterations = 20000;

}  // namespace

NewtonSystem::NewtonSystem(const Grid& grid, Hessian hessian, Solver solver)
    : solver_(solver), jacobian_(grid, hessian), inverse_(grid.particles(), 6), conjugate_gradients_(grid.particles()) {
    pinned_.reserve(static_cast<std::size_t>(grid.particles()));
    if (hessian == Hessian::Exact) bicgstab_ = std::make_unique<krylov::BiCgStab>(grid.particles());
}

void NewtonSystem::linearise(const ClothModel& model, const Points& x, const Points& v) {
    jacobian_.linearise(model, x, v);
    pinned_.clear();
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) pinned_.push_back(p);
    }
}

bool NewtonSystem::prefers_factors(const ClothModel&, Real) const {
    if (solver_ != Solver::Automatic) return solver_ == Solver::Factors;
    return false;
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
        for (const int p : {a, b}) {
            inverse_(p, 0) += block(0, 0), inverse_(p, 1) += block(0, 1), inverse_(p, 2) += block(0, 2);
            inverse_(p, 3) += block(1, 1), inverse_(p, 4) += block(1, 2), inverse_(p, 5) += block(2, 2);
        }
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
    const auto solve_with = [&](auto precondition) {
        const krylov::Limits limits{tolerance, most_iterations};
        if (bicgstab_) return bicgstab_->solve(r, dv, limits, apply, precondition);
        return conjugate_gradients_.solve(r, dv, limits, apply, precondition);
    };
    if (prefers_factors(model, s)) {
        if (!factor_) factor_ = std::make_unique<GridFactor>(model.grid);
        factor_->factorise(model, jacobian_, s * s, s);
        return solve_with([&](const Points& from, Points& to) { factor_->solve(from, to); });
    }
    invert_diagonal(model, s);
    return solve_with([&](const Points& from, Points& to) { apply_inverse_diagonal(from, to); });
}

}  // namespace drape
