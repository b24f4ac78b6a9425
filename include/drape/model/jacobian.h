#pragma once

#include <array>

#include "drape/base/enum_names.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// How the stiffness across a spring is seen. `Exact`: as it is. `Clamped`: a spring that pushes has none, and what the
/// damping adds to K is left out where it is not symmetric; K is then symmetric and positive semidefinite.
enum class Hessian { Clamped, Exact };

template <>
inline constexpr auto enum_names<Hessian> = all_names<Hessian>("clamped", "exact");

/// The slopes K = -df/dx and D = -df/dv of the forces of springs and air drag, spring by spring and never as a matrix.
///
/// A spring pulls with T = k (|d| - L0) + c n.w, where d = x_a - x_b, n = d/|d| and w = v_a - v_b. With P = I - n n',
/// its blocks, added at (a,a) and (b,b) and subtracted at (a,b) and (b,a), are
///
///     K: k n n' + T/|d| P + c/|d| n (P w)'        D: c n n'
///
/// `Clamped` takes max(T, 0) for T and drops the last, unsymmetric, term (as Baraff and Witkin do). A spring of zero
/// length has neither force nor slope. The wind's slopes are left out: it acts on the cloth explicitly, and methods of
/// second order are of first order in it.
/// @cite baraff1998
class Jacobian {
public:
    /// Makes room for a grid's springs; nothing later allocates.
    Jacobian(const Grid& grid, Hessian hessian);

    /// Takes the slopes at a state.
    /// @param x, v n x 3 [m], [m/s]
    /// @pre the model has this grid
    /// @par Cost O(n), about two force evaluations
    void linearise(const ClothModel& model, const Points& x, const Points& v);

    /// y += (k_scale K + d_scale D) u.
    /// @param u, y n x 3, two arrays; pinned particles are treated as any other
    /// @par Cost O(n), about one force evaluation
    void add_product(Real k_scale, Real d_scale, const Points& u, Points& y) const;

    [[nodiscard]] Hessian hessian() const { return hessian_; }
    [[nodiscard]] Real drag() const { return drag_; }

    using Block = Eigen::Matrix<Real, 3, 3>;

    /// Calls visit(a, b, block) for every spring, in a fixed order, with its block of the symmetric part of
    /// k_scale K + d_scale D; air drag is left out.
    template <class Visit>
    void for_each_block(Real k_scale, Real d_scale, Visit visit) const {
        for (const Family& family : families_) {
            const Real along = k_scale * family.stiffness + d_scale * family.damping;
            for (int j = 0; j < family.rows; ++j) {
                for (int i = 0; i < family.count; ++i) {
                    const int a = family.first + j * family.stride + i;
                    visit(a, a + family.reach, block(family, a, along, k_scale));
                }
            }
        }
    }

private:
    /// The springs of one direction, which join each particle a with a + reach. Between the end of one row's springs
    /// and the start of the next the slopes stay zero, so that a product can run over all rows at once.
    struct Family {
        Real stiffness = 0, damping = 0;
        int first = 0, reach = 0, rows = 0, count = 0, stride = 0;
        /// One row a spring, by its first particle: n (3 columns), T/|d| [N/m], and unless clamped c/|d| P w [N/m] (3).
        Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> slopes;
    };

    [[nodiscard]] static Block block(const Family& family, int a, Real along, Real k_scale) {
        const Vec3 n = family.slopes.row(a).head<3>().transpose();
        const Real across = k_scale * family.slopes(a, 3);
        Block result = (along - across) * n * n.transpose();
        result.diagonal().array() += across;
        if (family.slopes.cols() > 4) {
            const Vec3 skew = k_scale / 2 * family.slopes.row(a).tail<3>().transpose();
            result += n * skew.transpose() + skew * n.transpose();
        }
        return result;
    }

    Hessian hessian_;
    Real drag_ = 0;
    std::array<Family, 6> families_;
};

}  // namespace drape
