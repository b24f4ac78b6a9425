#include "drape/model/stretch_limit.h"

#include <algorithm>
#include <cmath>

#include "drape/model/stencils.h"

namespace drape {
namespace {

/// The springs that have a limit.
std::array<SpringStencil, 2> limited_springs(const ClothModel& model) {
    const auto stencils = spring_stencils(model);
    return {stencils[0], stencils[1]};
}

/// The longest spring of one direction [m].
Real greatest_length(const SpringStencil& springs, const Grid& grid, const Points& x) {
    Real square = 0;
    for (int j = 0; j < springs.rows(grid); ++j) {
        const int a = grid.particle(springs.first_column(), j), count = springs.count(grid);
        const auto d = x.middleRows(a, count).array() - x.middleRows(a + springs.offset(grid), count).array();
        square = std::max(square, (d.col(0).square() + d.col(1).square() + d.col(2).square()).maxCoeff());
    }
    return std::sqrt(square);
}

/// 1/m of a particle; the one that gives way counts as free.
Real inverse_mass_of(const ClothModel& model, int particle, int yielding) {
    return particle == yielding ? 1 / model.particle_mass : model.inverse_mass[particle];
}

/// Shortens one spring to the limit, and stops its ends from moving apart.
void shorten(const ClothModel& model, int yielding, int a, int b, Real longest, ClothState& state) {
    const Vec3 d = state.x.row(a) - state.x.row(b);
    const Real square = d.squaredNorm();
    if (square <= longest * longest) return;
    const Real w_a = inverse_mass_of(model, a, yielding), w_b = inverse_mass_of(model, b, yielding);
    if (w_a + w_b == 0) return;
    const Real length = std::sqrt(square);
    const Vec3 n = d / length;
    const Real part_a = w_a / (w_a + w_b), part_b = w_b / (w_a + w_b);
    const Vec3 move = (length - longest) * n;
    state.x.row(a) -= part_a * move.transpose();
    state.x.row(b) += part_b * move.transpose();

    const Real parting = n.dot(state.v.row(a) - state.v.row(b));
    if (parting <= 0) return;
    state.v.row(a) -= part_a * parting * n.transpose();
    state.v.row(b) += part_b * parting * n.transpose();
}

}  // namespace

Real largest_stretch(const ClothModel& model, const Points& x) {
    Real largest = -1;
    for (const SpringStencil& springs : limited_springs(model)) {
        largest = std::max(largest, greatest_length(springs, model.grid, x) / springs.rest_length - 1);
    }
    return largest;
}

Real stretch_excess(const ClothModel& model, const Points& x) {
    return model.stretch_limit == 0 ? 0 : std::max(largest_stretch(model, x) - model.stretch_limit, Real(0));
}

StretchReport limit_stretch(const ClothModel& model, int held, ClothState& state) {
    StretchReport report{.excess = stretch_excess(model, state.x)};
    while (report.excess > stretch_tolerance && report.sweeps < max_stretch_sweeps) {
        const int yielding = report.sweeps < max_stretch_sweeps / 2 ? -1 : held;
        // Always in the order of the grid: where pins ask too much, sweeps to and fro would leave it all to a few
        for (const SpringStencil& springs : limited_springs(model)) {
            const Real longest = (1 + model.stretch_limit) * springs.rest_length;
            springs.for_each(model.grid, [&](int a, int b) { shorten(model, yielding, a, b, longest, state); });
        }
        report.excess = stretch_excess(model, state.x);
        ++report.sweeps;
    }
    return report;
}

}  // namespace drape
