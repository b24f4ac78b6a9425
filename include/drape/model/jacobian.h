#pragma once

#include <array>

#include "drape/base/enum_names.h"
#include "drape/base/kernels.h"
#include "drape/base/workers.h"
#include "drape/model/forces.h"
#include "drape/model/stencils.h"

namespace drape {

/// How the stiffness across a spring is seen. `Exact`: as it is. `Clamped`: a spring that pushes has none, and what the
/// damping adds to K is left out where it is not symmetric; K is then symmetric and positive semidefinite.
enum class Hessian { Clamped, Exact };

/// The Jacobians K = -df/dx and D = -df/dv of the forces of springs, air drag and wind, spring by spring, triangle by
/// triangle, and never as a matrix.
///
/// A spring pulls with T = k (|d| - L0) + c n.w, where d = x_a - x_b, n = d/|d| and w = v_a - v_b. With P = I - n n',
/// its blocks, added at (a,a) and (b,b) and subtracted at (a,b) and (b,a), are
///
///     K: k n n' + T/|d| P + c/|d| n (P w)'        D: c n n'
///
/// `Clamped` takes max(T, 0) for T and drops the last, unsymmetric, term (as Baraff and Witkin do). The blocks of a
/// spring of zero length are zero, as its force is. A triangle in the wind has the block g g' of `wind_resistance` in
/// D, at each pair of its corners. How its force changes with its place is left out of K.
/// @cite baraff1998
class Jacobian {
public:
    /// Makes room for a grid's springs; nothing later allocates.
    /// @param threads that share the work; the result is the same
    Jacobian(const Grid& grid, Hessian hessian, Kernels kernels, int threads = 1);

    /// Takes the Jacobians at a state.
    /// @param x, v n x 3 [m], [m/s]
    /// @param facing the wind's as if it met each triangle along its normal: no turn of the cloth gives it more
    /// @pre the model has this grid
    /// @par Cost O(n), about two force evaluations; allocates once in the first wind
    void linearise(const ClothModel& model, const Points& x, const Points& v, bool facing = false);

    /// y += (k_scale K + d_scale D) u.
    /// @param u, y n x 3, two arrays; pinned particles are treated as any other
    /// @par Cost O(n), about one force evaluation
    void add_product(Real k_scale, Real d_scale, const Points& u, Points& y) const;

    [[nodiscard]] Real drag() const { return drag_; }

    using Block = Eigen::Matrix<Real, 3, 3>;

    /// The blocks of the springs of a direction, xx, xy, xz, yy, yz, zz by their first particles, and zero where there
    /// is no spring; of some particles.
    /// @param blocks n x 6, the rows of these particles overwritten
    /// @pre clamped
    template <class Blocks>
    void spring_blocks(std::size_t direction, Real k_scale, Real d_scale, Eigen::Index first, Eigen::Index count,
                       Blocks& blocks) const {
        using Scalar = typename Blocks::Scalar;
        const Family& family = families_[direction];
        if (family.none()) {
            blocks.middleRows(first, count).setZero();
            return;
        }
        const auto terms = family.terms.middleRows(first, count).array();
        const auto across = k_scale * terms.col(3);
        const Real along = family.along(k_scale, d_scale);
        Eigen::Index entry = 0;
        for (Eigen::Index r = 0; r < 3; ++r) {
            for (Eigen::Index c = r; c < 3; ++c) {
                auto to = blocks.col(entry++).segment(first, count);
                to = ((along - across) * terms.col(r) * terms.col(c)).template cast<Scalar>();
                if (r == c) to += across.template cast<Scalar>();
            }
        }
    }

    /// Calls visit(a, b, block) for what every triangle in the wind adds to k_scale K + d_scale D: where a is b, and
    /// once for each pair.
    template <class Visit>
    void for_each_wind_block(Real d_scale, Visit visit) const {
        for (int triangle = 0; triangle < wind_.rows(); ++triangle) {
            const auto [a, b, c] = grid_.triangle_corners(triangle);
            const Block added = d_scale * wind_.row(triangle).transpose() * wind_.row(triangle);
            for (const auto& [p, q] : {std::pair(a, a), {b, b}, {c, c}, {a, b}, {b, c}, {c, a}}) visit(p, q, added);
        }
    }

    /// The same of springs and triangles, in a fixed order: what they add to the symmetric part. Air drag is left out.
    template <class Visit>
    void for_each_block(Real k_scale, Real d_scale, Visit visit) const {
        for (const Family& family : families_) {
            if (family.none()) continue;
            const Real along = family.along(k_scale, d_scale);
            family.springs.for_each(grid_, [&](int a, int b) {
                const Block added = block(family, a, along, k_scale);
                visit(a, a, added);
                visit(b, b, added);
                visit(a, b, -added);
            });
        }
        for_each_wind_block(d_scale, visit);
    }

private:
    /// The springs of one direction. Between the end of one row's springs and the start of the next, what is known of
    /// them stays zero, so that a product can run over all rows at once.
    struct Family {
        SpringStencil springs{};
        /// One row a spring, by its first particle: n (3 columns), T/|d| [N/m], and unless clamped c/|d| P w [N/m] (3).
        Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> terms;

        [[nodiscard]] bool none() const { return springs.law == SpringLaw{}; }

        /// What a block does to a vector along the spring.
        [[nodiscard]] Real along(Real k_scale, Real d_scale) const {
            return k_scale * springs.law.stiffness + d_scale * springs.law.damping;
        }
    };

    template <class Visit>
    void for_bands(Visit visit) const;

    [[nodiscard]] static Block block(const Family& family, int a, Real along, Real k_scale) {
        const Vec3 n = family.terms.row(a).head<3>().transpose();
        const Real across = k_scale * family.terms(a, 3);
        Block result = (along - across) * n * n.transpose();
        result.diagonal().array() += across;
        if (family.terms.cols() > 4) {
            const Vec3 skew = k_scale / 2 * family.terms.row(a).tail<3>().transpose();
            result += n * skew.transpose() + skew * n.transpose();
        }
        return result;
    }

    Grid grid_;
    Kernels kernels_;
    mutable LazyWorkers workers_;
    Real drag_ = 0;
    std::array<Family, 6> families_;
    Points wind_;  ///< g of each triangle [sqrt(N s/m)]; none without wind
};

}  // namespace drape
