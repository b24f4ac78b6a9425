#include "drape/model/jacobian.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "kernels/jacobian_kernels.h"

namespace drape {
namespace {

void linearise_plainly(const SpringStencil& springs, const Grid& grid, const Points& x, const Points& v,
                       kernels::SpringTerms& all) {
    const Real k = springs.law.stiffness, c = springs.law.damping;
    springs.for_each(grid, [&](int a, int b) {
        const Vec3 d = x.row(a) - x.row(b), w = v.row(a) - v.row(b);
        const Real length = d.norm();
        auto terms = all.row(a);
        terms.setZero();
        if (length == 0) return;
        const Vec3 n = d / length;
        const bool clamped = terms.size() == 4;
        const Real tension = k * (length - springs.rest_length) + c * n.dot(w);
        terms.head<3>() = n.transpose();
        terms[3] = (clamped ? std::max(tension, Real(0)) : tension) / length;
        if (!clamped) terms.tail<3>() = c / length * (w - n.dot(w) * n).transpose();
    });
}

void add_product_plainly(const SpringStencil& springs, const Grid& grid, const kernels::SpringTerms& all, Real along,
                         Real k_scale, const Points& u, Points& y) {
    springs.for_each(grid, [&](int a, int b) {
        const auto terms = all.row(a);
        const Vec3 n = terms.head<3>(), d = u.row(a) - u.row(b);
        const Real across = k_scale * terms[3];
        Vec3 product = across * d + (along - across) * n.dot(d) * n;
        if (terms.size() > 4) product += k_scale * terms.tail<3>().dot(d) * n;
        y.row(a) += product.transpose();
        y.row(b) -= product.transpose();
    });
}

}  // namespace

Jacobian::Jacobian(const Grid& grid, Hessian hessian, Kernels kernels) : grid_(grid), kernels_(kernels) {
    for (Family& family : families_) family.terms.setZero(grid.particles(), hessian == Hessian::Exact ? 7 : 4);
}

void Jacobian::linearise(const ClothModel& model, const Points& x, const Points& v, bool facing) {
    DRAPE_ASSERT(grid_ == model.grid && x.rows() == grid_.particles() && v.rows() == grid_.particles());
    drag_ = model.drag;
    const auto stencils = spring_stencils(model);
    for (std::size_t s = 0; s < stencils.size(); ++s) {
        Family& family = families_[s];
        family.springs = stencils[s];
        if (family.none()) continue;
        (kernels_ == Kernels::Plain ? linearise_plainly : kernels::linearise)(family.springs, grid_, x, v,
                                                                              family.terms);
    }
    wind_.resize(model.air.density > 0 ? grid_.triangles() : 0, 3);
    for (int triangle = 0; triangle < wind_.rows(); ++triangle) {
        const auto [a, b, c] = grid_.triangle_corners(triangle);
        wind_.row(triangle) =
            wind_resistance(model.air, {x.row(a), x.row(b), x.row(c)}, {v.row(a), v.row(b), v.row(c)}, facing);
    }
}

void Jacobian::add_product(Real k_scale, Real d_scale, const Points& u, Points& y) const {
    y += (d_scale * drag_) * u;
    for (const Family& family : families_) {
        if (family.none()) continue;
        (kernels_ == Kernels::Plain ? add_product_plainly : kernels::add_product)(
            family.springs, grid_, family.terms, family.along(k_scale, d_scale), k_scale, u, y);
    }
    for (int triangle = 0; triangle < wind_.rows(); ++triangle) {
        const auto [a, b, c] = grid_.triangle_corners(triangle);
        const auto g = wind_.row(triangle);
        const auto product = (d_scale * g.dot(u.row(a) + u.row(b) + u.row(c)) * g).eval();
        for (const int corner : {a, b, c}) y.row(corner) += product;
    }
}

}  // namespace drape
