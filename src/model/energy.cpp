#include "drape/model/energy.h"

#include <algorithm>
#include <cmath>

#include "drape/model/stencils.h"

namespace drape {
namespace {

/// Calls visit(length) for every spring of a stencil, row by row.
template <class Visit>
void for_each_length(const SpringStencil& stencil, const Grid& grid, const Points& x, Visit visit) {
    for (int j = 0; j < stencil.rows(grid); ++j) {
        const int a = grid.particle(stencil.first_column(), j);
        const int b = a + stencil.dj * grid.nx + stencil.di;
        for (int i = 0; i < stencil.count(grid); ++i) visit((x.row(a + i) - x.row(b + i)).norm());
    }
}

}  // namespace

Energy compute_energy(const ClothModel& model, const ClothState& state) {
    Energy energy;
    for (Eigen::Index p = 0; p < state.x.rows(); ++p) {
        energy.kinetic += model.particle_mass * state.v.row(p).squaredNorm() / 2;
        energy.gravity -= model.particle_mass * state.x.row(p).dot(model.gravity.transpose());
    }
    for (const SpringStencil& stencil : spring_stencils(model)) {
        for_each_length(stencil, model.grid, state.x, [&](Real length) {
            const Real elongation = length - stencil.rest_length;
            energy.spring += stencil.law.stiffness * elongation * elongation / 2;
        });
    }
    return energy;
}

Real largest_stretch(const ClothModel& model, const Points& x) {
    Real largest = -1;
    const auto stencils = spring_stencils(model);
    for (const SpringStencil& stencil : {stencils[0], stencils[1]}) {
        for_each_length(stencil, model.grid, x,
                        [&](Real length) { largest = std::max(largest, length / stencil.rest_length - 1); });
    }
    return largest;
}

}  // namespace drape
