#include "drape/integrate/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drape/model/forces.h"
#include "mode_search.h"

namespace drape {
namespace {

/// The longest step with which implicit midpoint keeps a sheet in the wind from fluttering faster and faster. Its
/// matrix has how the wind resists velocities, but not how its force turns with the triangles, which makes a pressure p
/// on cells of size s as stiff as p s; and it damps nothing. So it goes up to z = 2, as methods do that take a
/// force from the positions before. (Backward Euler and BDF2, which leave out the same, damp it.) A rough measure, as
/// runs bear out within a factor of two.
double longest_of_midpoint(const ClothModel& model, const ClothState& state) {
    const auto speed =
        static_cast<double>((state.v.rowwise() - model.air.velocity.transpose()).rowwise().norm().maxCoeff());
    const double pressure = static_cast<double>(plate_coefficient * model.air.density) / 2 * speed * speed;
    return 2 * std::sqrt(static_cast<double>(model.particle_mass / std::max(model.hx, model.hy)) / pressure);
}

/// True if a step that is the limit of a vibration's Rayleigh quotients is that of the cloth: if the vibration is an
/// eigenvector of K and D both, or of lambda^2 + lambda D + K where it does not swing. Symplectic Euler's always is.
bool decides(IntegratorKind kind, const Mode& mode) {
    if (kind == IntegratorKind::SymplecticEuler) return true;
    constexpr double small = 0.03;
    const auto k = static_cast<double>(mode.stiffness), d = static_cast<double>(mode.damping);
    const auto of_k = static_cast<double>(mode.stiffness_variance), of_d = static_cast<double>(mode.damping_variance);
    if (kind == IntegratorKind::ExplicitEuler && d * d < 4 * k) {
        return of_k <= small * small * k * k && of_d <= small * small * d * d;
    }
    const double root = d * d - 4 * k, real = root > 0 ? -(d + std::sqrt(root)) / 2 : -d / 2;
    const double square = root > 0 ? real * real : k, size = square + std::sqrt(square) * d + k;
    return square * of_d + of_k + 2 * real * static_cast<double>(mode.covariance) <= small * small * size * size;
}

/// The pieces of at most `window` particles into which a row or column is cut.
constexpr int window = 64;
int pieces(int particles) { return (particles + window - 1) / window; }

/// A piece of a cloth, from a column and row on; what it hangs on is cut off, so that none of its vibrations is faster
/// than the whole cloth's.
struct Piece {
    int column, row;
    ClothModel model;
    ClothState state;
};

Piece cut_out(const ClothModel& model, const ClothState& state, int column, int row) {
    const auto start = [](int piece, int particles) { return piece * particles / pieces(particles); };
    const int i = start(column, model.grid.nx), j = start(row, model.grid.ny);
    const Grid grid{start(column + 1, model.grid.nx) - i, start(row + 1, model.grid.ny) - j};
    Piece piece{i, j, model, {Points(grid.particles(), 3), Points(grid.particles(), 3)}};
    piece.model.grid = grid;
    piece.model.inverse_mass.resize(grid.particles());
    for (int r = 0; r < grid.ny; ++r) {
        const int to = grid.particle(0, r), from = model.grid.particle(i, j + r);
        piece.model.inverse_mass.segment(to, grid.nx) = model.inverse_mass.segment(from, grid.nx);
        piece.state.x.middleRows(to, grid.nx) = state.x.middleRows(from, grid.nx);
        piece.state.v.middleRows(to, grid.nx) = state.v.middleRows(from, grid.nx);
    }
    return piece;
}

/// True if all springs are damped in proportion to their stiffness: then the stiffest vibration is the most damped one.
bool damped_alike(const ClothModel& model) {
    const std::array<SpringLaw, 3> laws{model.structural, model.shear, model.bend};
    return std::ranges::all_of(laws, [&](const SpringLaw& one) {
        return std::ranges::all_of(laws, [&](const SpringLaw& other) {
            return one.damping * other.stiffness == other.damping * one.stiffness;
        });
    });
}

/// The piece of a large cloth in which vibrations have the shortest limit, as far as a glance tells: that of symplectic
/// Euler, which falls with stiffness and with damping.
Piece critical_piece(const ClothModel& model, const ClothState& state, Kernels kernels) {
    constexpr int glance = 4;
    const bool alike = damped_alike(model);
    std::array<int, 2> critical{};
    double shortest = std::numeric_limits<double>::infinity();
    for (int row = 0; row < pieces(model.grid.ny); ++row) {
        for (int column = 0; column < pieces(model.grid.nx); ++column) {
            const Piece piece = cut_out(model, state, column, row);
            ModeSearch search(piece.model, piece.state, kernels);
            const Real stiffness = search.maximise(1, 0, glance), damping = alike ? 0 : search.maximise(0, 1, glance);
            const double step = longest_step(IntegratorKind::SymplecticEuler, static_cast<double>(stiffness),
                                             static_cast<double>(damping));
            if (step < shortest) shortest = step, critical = {column, row};
        }
    }
    return cut_out(model, state, critical[0], critical[1]);
}

LimitingMode mode_of(const ClothModel& model, const ClothState& state, IntegratorKind kind, Kernels kernels) {
    ModeSearch search(model, state, kernels);
    LimitSearch limits(search, static_cast<double>(model.drag / model.particle_mass),
                       [kind](double k, double d) { return longest_step(kind, k, d); });
    return limits.find([kind](const Mode& mode) { return decides(kind, mode); });
}

}  // namespace

bool has_step_limit(IntegratorKind kind) { return method_of(kind).longest_step != nullptr; }

double longest_step(IntegratorKind kind, double k, double d) {
    const LongestStep limit = method_of(kind).longest_step;
    return limit == nullptr || (k == 0 && d == 0) ? std::numeric_limits<double>::infinity() : limit(k, d);
}

StepLimit predicted_limit(const ClothModel& model, const ClothState& state, IntegratorKind kind, Kernels kernels) {
    return limiting_mode(model, state, kind, kernels).limit;
}

LimitingMode limiting_mode(const ClothModel& model, const ClothState& state, IntegratorKind kind, Kernels kernels) {
    if (!has_step_limit(kind)) {
        const bool flutters = kind == IntegratorKind::ImplicitMidpoint && model.air.density > 0;
        const double step = flutters ? longest_of_midpoint(model, state) : std::numeric_limits<double>::infinity();
        return {{.step = static_cast<Real>(step)}, {}};
    }
    if (pieces(model.grid.nx) * pieces(model.grid.ny) == 1) return mode_of(model, state, kind, kernels);
    const Piece piece = critical_piece(model, state, kernels);
    const LimitingMode of_piece = mode_of(piece.model, piece.state, kind, kernels);
    LimitingMode mode{of_piece.limit, Points::Zero(model.grid.particles(), 3)};
    const Grid& grid = piece.model.grid;
    for (int r = 0; r < grid.ny && of_piece.shape.size() > 0; ++r) {
        mode.shape.middleRows(model.grid.particle(piece.column, piece.row + r), grid.nx) =
            of_piece.shape.middleRows(grid.particle(0, r), grid.nx);
    }
    return mode;
}

}  // namespace drape
