#include "drape/model/jacobian.h"

#include <algorithm>

#include "drape/base/assert.h"
#include "kernels/jacobian_kernels.h"

namespace drape {
namespace {

/// The cloth is taken in bands of so many rows: the bits do not depend on how threads share these.
constexpr int band_rows = 32;

/// Particles that are worth a thread.
constexpr std::size_t worth_a_thread = 8192;

void linearise_plainly(const SpringRows& rows, const Points& x, const Points& v, kernels::SpringTerms& all) {
    const Real k = rows.springs.law.stiffness, c = rows.springs.law.damping;
    rows.for_each([&](int a, int b) {
        const Vec3 d = x.row(a) - x.row(b), w = v.row(a) - v.row(b);
        const Real length = d.norm();
        auto terms = all.row(a);
        terms.setZero();
        if (length == 0) return;
        const Vec3 n = d / length;
        const bool clamped = terms.size() == 4;
        const Real tension = k * (length - rows.springs.rest_length) + c * n.dot(w);
        terms.head<3>() = n.transpose();
        terms[3] = (clamped ? std::max(tension, Real(0)) : tension) / length;
        if (!clamped) terms.tail<3>() = c / length * (w - n.dot(w) * n).transpose();
    });
}

void add_product_plainly(const SpringRows& rows, const kernels::SpringTerms& all, Real along, Real k_scale,
                         const Points& u, Points& y) {
    rows.for_each([&](int a, int b) {
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

Jacobian::Jacobian(const Grid& grid, Hessian hessian, Kernels kernels, int threads) : grid_(grid), kernels_(kernels) {
    workers_.use(threads);
    for (Family& family : families_) family.terms.setZero(grid.particles(), hessian == Hessian::Exact ? 7 : 4);
}

void Jacobian::linearise(const ClothModel& model, const Points& x, const Points& v, bool facing) {
    DRAPE_ASSERT(grid_ == model.grid && x.rows() == grid_.particles() && v.rows() == grid_.particles());
    drag_ = model.drag;
    const auto stencils = spring_stencils(model);
    for (std::size_t s = 0; s < stencils.size(); ++s) families_[s].springs = stencils[s];
    for_bands([&](int from, int end) {
        for (Family& family : families_) {
            if (family.none()) continue;
            (kernels_ == Kernels::Plain ? linearise_plainly : kernels::linearise)({family.springs, grid_, from, end}, x,
                                                                                  v, family.terms);
        }
    });
    wind_.resize(model.air.density > 0 ? grid_.triangles() : 0, 3);
    for (int triangle = 0; triangle < wind_.rows(); ++triangle) {
        const auto [a, b, c] = grid_.triangle_corners(triangle);
        wind_.row(triangle) =
            wind_resistance(model.air, {x.row(a), x.row(b), x.row(c)}, {v.row(a), v.row(b), v.row(c)}, facing);
    }
}

/// Calls visit(from, end) for each band of rows, shared among threads.
template <class Visit>
void Jacobian::for_bands(Visit visit) const {
    const int bands = std::max(grid_.ny / band_rows, 1);
    workers_.run(static_cast<std::size_t>(grid_.particles()) / worth_a_thread, [&](int part, int parts) {
        for (int band = bands * part / parts; band < bands * (part + 1) / parts; ++band) {
            visit(grid_.ny * band / bands, grid_.ny * (band + 1) / bands);
        }
    });
}

void Jacobian::add_product(Real k_scale, Real d_scale, const Points& u, Points& y) const {
    const auto add = [&](const Family& family, int from, int end) {
        if (family.none()) return;
        (kernels_ == Kernels::Plain ? add_product_plainly : kernels::add_product)(
            {family.springs, grid_, from, end}, family.terms, family.along(k_scale, d_scale), k_scale, u, y);
    };
    for_bands([&](int from, int end) {
        const int first = grid_.particle(0, from), count = grid_.particle(0, end - from);
        y.middleRows(first, count) += (d_scale * drag_) * u.middleRows(first, count);
        for (const Family& family : families_) add(family, from, end == grid_.ny ? end : end - family.springs.dj);
    });
    // Springs from one band to the next
    const int bands = std::max(grid_.ny / band_rows, 1);
    for (int band = 1; band < bands; ++band) {
        const int border = grid_.ny * band / bands;
        for (const Family& family : families_) add(family, border - family.springs.dj, border);
    }
    for (int triangle = 0; triangle < wind_.rows(); ++triangle) {
        const auto [a, b, c] = grid_.triangle_corners(triangle);
        const auto g = wind_.row(triangle);
        const auto product = (d_scale * g.dot(u.row(a) + u.row(b) + u.row(c)) * g).eval();
        for (const int corner : {a, b, c}) y.row(corner) += product;
    }
}

}  // namespace drape
