#include "spring_passes.h"

#include "drape/base/assert.h"
#include "kernels/spring_pass_kernels.h"

namespace drape {
namespace {

/// Corrects the spring of ends a and b, as the header says.
void correct_spring(const StepSprings& step, int a, int b, const Points& start, Points& x) {
    const Real hhk = step.h * step.h * step.springs.law.stiffness, hc = step.h * step.springs.law.damping;
    const Real w_a = step.weights[a], w_b = step.weights[b];
    const Vec3 d = x.row(a) - x.row(b), d_start = start.row(a) - start.row(b);
    const Real length = d.norm();
    if (length == 0) return;
    const Vec3 n = d / length;
    Real& q = step.multipliers[a];
    const Real c = length - step.springs.rest_length, dc = n.dot(d - d_start);
    const Real dq = -(hhk * c + hc * dc + q) / ((hhk + hc) * (w_a + w_b) + 1);
    q += dq;
    x.row(a) += w_a * dq * n.transpose();
    x.row(b) -= w_b * dq * n.transpose();
}

/// In the order of the kernel, which is that of Gauss-Seidel: it matters.
void correct_springs(const StepSprings& step, const Grid& grid, const Points& start, Points& x) {
    const SpringStencil& springs = step.springs;
    for (int j = 0; j < springs.rows(grid); ++j) {
        for (int first = 0; first < step.stride(); ++first) {
            for (int i = first; i < springs.count(grid); i += step.stride()) {
                const int a = grid.particle(springs.first_column() + i, j);
                correct_spring(step, a, a + springs.offset(grid), start, x);
            }
        }
    }
}

}  // namespace

SpringPasses::SpringPasses(const Grid& grid, Kernels kernels)
    : grid_(grid), kernels_(kernels), weights_(grid.particles()), multipliers_(grid.particles(), 6) {}

void SpringPasses::begin(const ClothModel& model, const Eigen::Array<Real, Eigen::Dynamic, 1>& inertia, Real h) {
    h_ = h;
    weights_ = model.inverse_mass * (model.particle_mass / inertia);
    multipliers_.setZero();
}

void SpringPasses::pass(const std::array<SpringStencil, 6>& springs, const Points& start, Points& x) {
    DRAPE_ASSERT(start.rows() == grid_.particles() && x.rows() == grid_.particles());
    for (std::size_t direction = 0; direction < springs.size(); ++direction) {
        if (springs[direction].law == SpringLaw{}) continue;
        Real* const q = multipliers_.col(static_cast<Eigen::Index>(direction)).data();
        const StepSprings step{springs[direction], h_, weights_.data(), q};
        (kernels_ == Kernels::Plain ? correct_springs : kernels::correct_springs)(step, grid_, start, x);
    }
}

}  // namespace drape
