#include <algorithm>
#include <bit>

#include "newton_system.h"

namespace drape {
namespace {

/// An entry of a sparse matrix: value and row.
constexpr double entry = sizeof(Real) + sizeof(int);

/// The binary logarithm, to a half.
double log_two(const Grid& grid) { return std::bit_width(static_cast<unsigned>(grid.particles())) - 0.5; }

/// Entries a particle of all that factorising a symmetric matrix over the grid takes at once. The factors of a square
/// grid have O(n log n) entries under a good order of elimination.
double factor_entries(const Grid& grid) { return std::max(12.5 * log_two(grid) - 17, 100.0); }

/// The same for three coordinates to a particle: nine entries where there was one, less what is found once only.
double block_factor_entries(const Grid& grid) { return std::max(75 * log_two(grid) - 350, 165.0); }

/// Numbers a particle of the linear system: Jacobians, inverse blocks, and the vectors of the solver.
double numbers_of_system(const IntegratorParameters& parameters) {
    return (parameters.hessian == Hessian::Exact ? 75 : 39) + (parameters.newton_steps > 1 ? 15 : 0);
}

/// Of multigrid, a particle: stencils and vectors of the finest level, a third of that for all others, and two blocks.
constexpr double multigrid_bytes = sizeof(float) * (4.0 / 3 * (13 * 6 + 6 + 6 * 3) + 2 * 6);

/// What a method keeps to solve with, a particle.
double kept_bytes(const IntegratorParameters& parameters, const Grid& grid) {
    switch (method_of(parameters.kind).keeps) {
        case Keeps::ScalarFactors:
            return entry * factor_entries(grid);
        case Keeps::NewtonSystem:
            return sizeof(Real) * numbers_of_system(parameters) +
                   (NewtonSystem::keeps_factors(grid, parameters.hessian) ? entry * block_factor_entries(grid) : 0) +
                   (NewtonSystem::keeps_multigrid(grid, parameters.hessian) ? multigrid_bytes : 0);
        case Keeps::Nothing:
            break;
    }
    return 0;
}

}  // namespace

double bytes_of_method(const IntegratorParameters& parameters, const Grid& grid) {
    constexpr double rows_of_a_sweep = 109, margins = 36;
    const double sweep = sizeof(Real) * rows_of_a_sweep * (grid.nx + margins);
    return sweep +
           grid.particles() * (sizeof(Real) * method_of(parameters.kind).numbers + kept_bytes(parameters, grid));
}

}  // namespace drape
