#include "drape/integrate/stability.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mode_search.h"

namespace drape {
namespace {

using Matrix = Eigen::Matrix2d;

/// One step of x'' = -k x - d x' on (x, v).
Matrix amplification(IntegratorKind kind, double k, double d, double h) {
    const Matrix same = Matrix::Identity();
    Matrix rate;
    rate << 0, 1, -k, -d;
    if (kind == IntegratorKind::Rk4) {
        const Matrix z = h * rate;
        return same + z * (same + z / 2 * (same + z / 3 * (same + z / 4)));
    }
    // Velocity Verlet: the second force sees x_{n+1} and v + h a
    Matrix drift = Matrix::Zero(), kick = Matrix::Zero();
    drift.row(0) = h * rate.row(0);
    kick.row(1) = h * rate.row(1);
    const Matrix moved = same + drift + drift * kick / 2;
    return moved + kick / 2 + kick / 2 * (moved + kick);
}

/// True if both eigenvalues lie in the unit circle, by the criterion of Jury.
bool bounded(const Matrix& step) {
    constexpr double rounding = 1e-12;
    const double trace = step.trace(), product = step.determinant();
    return product <= 1 + rounding && std::abs(trace) <= 1 + product + rounding;
}

/// Where the amplification of Verlet or RK4 reaches 1.
double bisected_step(IntegratorKind kind, double k, double d) {
    const double fastest = d * d > 4 * k ? (d + std::sqrt(d * d - 4 * k)) / 2 : std::sqrt(k);
    double stable = 0, unstable = 4 / fastest;  // neither method reaches three
    for (int bisection = 0; bisection < 50; ++bisection) {
        const double middle = (stable + unstable) / 2;
        (bounded(amplification(kind, k, d, middle)) ? stable : unstable) = middle;
    }
    return stable;
}

double longest(IntegratorKind kind, double k, double d) {
    if (!has_step_limit(kind) || (k == 0 && d == 0)) return std::numeric_limits<double>::infinity();
    switch (kind) {
        case IntegratorKind::ExplicitEuler:
            return d * d <= 4 * k ? d / k : 4 / (d + std::sqrt(d * d - 4 * k));
        case IntegratorKind::SymplecticEuler:
            return 4 / (d + std::sqrt(d * d + 4 * k));
        default:
            return bisected_step(kind, k, d);
    }
}

/// Where the limit falls fastest, as weights of k and d; neither is zero unless both are.
struct Descent {
    Real of_stiffness = 1, of_damping = 0;
};

Descent descent_at(IntegratorKind kind, double k, double d) {
    constexpr double part = 1e-3;
    const double here = longest(kind, k, d), scale = std::sqrt(k);
    const double by_k = (longest(kind, k * (1 + part), d) - here) / (part * k);
    const double by_d = (longest(kind, k, d + part * scale) - here) / (part * scale);
    const double size = std::abs(by_k) + std::abs(by_d) / scale;
    return {static_cast<Real>(-by_k / size), static_cast<Real>(-by_d / size)};
}

/// The pieces of at most `window` particles into which a row or column is cut.
constexpr int window = 64;
int pieces(int particles) { return (particles + window - 1) / window; }

/// A piece of a cloth; what it hangs on is cut off, so that none of its vibrations is faster than the whole cloth's.
struct Piece {
    ClothModel model;
    ClothState state;
};

Piece cut_out(const ClothModel& model, const ClothState& state, int column, int row) {
    const auto start = [](int piece, int particles) { return piece * particles / pieces(particles); };
    const int i = start(column, model.grid.nx), j = start(row, model.grid.ny);
    const Grid grid{start(column + 1, model.grid.nx) - i, start(row + 1, model.grid.ny) - j};
    Piece piece{model, {Points(grid.particles(), 3), Points(grid.particles(), 3)}};
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

/// The piece of a large cloth with the fastest vibration.
Piece fastest_piece(const ClothModel& model, const ClothState& state) {
    constexpr int glance = 4;
    std::array<int, 2> fastest{};
    Real highest = -1;
    for (int row = 0; row < pieces(model.grid.ny); ++row) {
        for (int column = 0; column < pieces(model.grid.nx); ++column) {
            const Piece piece = cut_out(model, state, column, row);
            ModeSearch search(piece.model, piece.state);
            const Real height = search.climb(1, 0, glance);
            if (height > highest) highest = height, fastest = {column, row};
        }
    }
    return cut_out(model, state, fastest[0], fastest[1]);
}

std::string_view formula_of(IntegratorKind kind) {
    switch (kind) {
        case IntegratorKind::ExplicitEuler:
            return "z = 2 zeta up to zeta = 1, else 2/(zeta + sqrt(zeta^2 - 1))";
        case IntegratorKind::SymplecticEuler:
            return "z = 2 (sqrt(1 + zeta^2) - zeta)";
        case IntegratorKind::VelocityVerlet:
            return "|amplification(z, zeta)| = 1; z = 2 undamped";
        case IntegratorKind::Rk4:
            return "|amplification(z, zeta)| = 1; z = 2 sqrt(2) undamped";
        default:
            return "no linear limit";
    }
}

StepLimit limit_of(const ClothModel& model, const ClothState& state, IntegratorKind kind) {
    constexpr int turns = 200, rounds = 6;
    constexpr Real gain = Real(1e-4);
    ModeSearch search(model, state);
    search.climb(1, 0, turns);
    Mode mode = search.mode();
    Real step = longest_step(kind, mode.stiffness, mode.damping);
    for (int round = 1; round < rounds && mode.stiffness > 0 && mode.damping > 0; ++round) {
        const auto [a, b] = descent_at(kind, static_cast<double>(mode.stiffness), static_cast<double>(mode.damping));
        search.climb(a, b, turns);
        const Mode next = search.mode();
        const Real next_step = longest_step(kind, next.stiffness, next.damping);
        if (!(next_step < (1 - gain) * step)) break;
        mode = next;
        step = next_step;
    }
    const Real omega = std::sqrt(mode.stiffness);
    return {omega, omega > 0 ? mode.damping / (2 * omega) : Real(0), step, formula_of(kind)};
}

}  // namespace

bool has_step_limit(IntegratorKind kind) {
    return kind == IntegratorKind::ExplicitEuler || kind == IntegratorKind::SymplecticEuler ||
           kind == IntegratorKind::VelocityVerlet || kind == IntegratorKind::Rk4;
}

Real longest_step(IntegratorKind kind, Real k, Real d) {
    return static_cast<Real>(longest(kind, static_cast<double>(k), static_cast<double>(d)));
}

StepLimit predicted_limit(const ClothModel& model, const ClothState& state, IntegratorKind kind) {
    if (pieces(model.grid.nx) * pieces(model.grid.ny) == 1) return limit_of(model, state, kind);
    const Piece piece = fastest_piece(model, state);
    return limit_of(piece.model, piece.state, kind);
}

}  // namespace drape
