#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <vector>

#include "drape/base/assert.h"
#include "drape/integrate/integrator.h"
#include "drape/model/stencils.h"
#include "krylov.h"
#include "spring_passes.h"

namespace drape {

/// The matrix M / h^2 + sum k A'A over all springs, with A x = x_a - x_b and M the particles' inertia: n x n, the same
/// for x, y and z. Without wind it changes with step, masses, stiffnesses and pins only, so that its factors L D L'
/// serve many steps. A pinned particle keeps its place with the row of an identity matrix: the pattern is the grid's,
/// and is analysed once.
/// @cite bouaziz2014
class GlobalMatrix {
public:
    explicit GlobalMatrix(const Grid& grid) : grid_(grid) {}

    /// Makes the factors unless those at hand are of this very matrix.
    /// @par Cost O(n) to compare; about O(n^1.5) to factorise, allocates
    void prepare(const ClothModel& model, const Numbers& inertia, Real h) {
        DRAPE_ASSERT(model.grid == grid_);
        const std::array<Real, 3> stiffnesses{model.structural.stiffness, model.shear.stiffness, model.bend.stiffness};
        const auto diagonal = (model.inverse_mass > 0).select(inertia / (h * h), Real(0));
        if (stiffnesses == stiffnesses_ && diagonal_.size() == diagonal.size() && (diagonal_ == diagonal).all()) return;
        stiffnesses_ = stiffnesses;
        diagonal_ = diagonal;
        factorise(model);
    }

    /// r = (this matrix)^-1 r: L q = r, then L' q = D^-1 q, for the three columns of q at once. By Eigen, which takes
    /// one column after the other, it takes twice the time.
    /// @param r n x 3; where it is zero at a pinned particle it stays so
    /// @par Cost as many multiplications as the factors have entries, six times; allocates nothing
    void solve(Points& r) {
        const auto& place = factors_.permutationP().indices();
        for (Eigen::Index p = 0; p < r.rows(); ++p) rows_.row(place[p]) = r.row(p);
        const Matrix& lower = factors_.matrixL().nestedExpression();  // without its diagonal of ones
        for (Eigen::Index j = 0; j < lower.cols(); ++j) {
            const Row q = rows_.row(j);
            for (Matrix::InnerIterator entry(lower, j); entry; ++entry) rows_.row(entry.row()) -= entry.value() * q;
        }
        for (Eigen::Index j = lower.cols(); j-- > 0;) {
            Row below = Row::Zero();
            for (Matrix::InnerIterator entry(lower, j); entry; ++entry) below += entry.value() * rows_.row(entry.row());
            rows_.row(j) = rows_.row(j) / pivots_[j] - below;
        }
        for (Eigen::Index p = 0; p < r.rows(); ++p) r.row(p) = rows_.row(place[p]);
    }

private:
    using Matrix = Eigen::SparseMatrix<Real>;
    using Row = Eigen::Matrix<Real, 1, 3>;

    void factorise(const ClothModel& model) {
        // Springs; those of stiffness zero and of pinned particles leave zeros, to keep the pattern
        constexpr int families = 6, entries_of_spring = 4;
        std::vector<Eigen::Triplet<Real>> entries;
        entries.reserve(static_cast<std::size_t>(grid_.particles()) * (families * entries_of_spring + 1));
        const auto free = [&](int particle) { return model.pinned(particle) ? Real(0) : Real(1); };
        for (const SpringStencil& springs : spring_stencils(model)) {
            const Real k = springs.law.stiffness;
            springs.for_each(grid_, [&](int a, int b) {
                entries.emplace_back(a, a, k * free(a));
                entries.emplace_back(b, b, k * free(b));
                entries.emplace_back(a, b, -k * free(a) * free(b));
                entries.emplace_back(b, a, -k * free(a) * free(b));
            });
        }
        for (int p = 0; p < grid_.particles(); ++p) {
            entries.emplace_back(p, p, model.pinned(p) ? Real(1) : diagonal_[p]);
        }

        const bool analysed = matrix_.rows() > 0;
        matrix_.resize(grid_.particles(), grid_.particles());
        matrix_.setFromTriplets(entries.begin(), entries.end());
        if (!analysed) factors_.analyzePattern(matrix_);
        factors_.factorize(matrix_);
        pivots_ = factors_.vectorD();
        rows_.resize(grid_.particles(), 3);
    }

    Grid grid_;
    std::array<Real, 3> stiffnesses_{};  ///< that the factors were made from; so is the next
    Numbers diagonal_;                   ///< inertia / h^2, and 0 for a pinned particle [kg/s^2]
    Matrix matrix_;
    Eigen::SimplicialLDLT<Matrix> factors_;
    Eigen::Matrix<Real, Eigen::Dynamic, 1> pivots_;
    Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor> rows_;  ///< in the order of elimination
};

/// Projective dynamics: minimises M/(2 h^2) |x - y|^2 + the springs' energy over x, with y the inertial guess and M the
/// particles' inertia. The local half of a round finds for each spring the vector of its rest length nearest to it, the
/// global half solves for the positions with those held. The change of x over both is G^-1 (M/h^2 (y - x) + f(x)), with
/// f the forces of the springs and G the global matrix, which is how it is computed.
///
/// A few rounds do not take back what springs forbid of the guess: a taut sheet stays where it is not at rest. In the
/// wind, which presses on such sheets, the rounds therefore begin where the motion alone leads, from which a cloth at
/// rest has nowhere to go. Without wind they begin at the guess.
///
/// The springs' damping is in the guess: before anything else, one implicit Gauss-Seidel pass over dampers slows the
/// velocities. So no step is too long for it, and a cloth at rest stays where its forces balance.
/// @cite liu2013 @cite bouaziz2014
class ProjectiveDynamics final : public Integrator {
public:
    ProjectiveDynamics(const IntegratorParameters& parameters, const Grid& grid)
        : iterations_(parameters.iterations),
          inertial_(grid, parameters.kernels),
          dampers_(grid, parameters.kernels),
          forces_(grid, parameters.kernels),
          global_(grid),
          start_(grid.particles(), 3),
          guess_(grid.particles(), 3),
          moved_(grid.particles(), 3),
          r_(grid.particles(), 3) {}

    SolveReport step(const ClothModel& model, ClothState& state, Real h) override {
        find_inertia(model, state, h, inertia_);
        global_.prepare(model, inertia_, h);
        keep_springs_of(model);
        damp(model, state, h);
        guess(model, state, h);
        inertia_ /= h * h;
        Real unbalanced = 0;
        for (int iteration = 0; iteration < iterations_; ++iteration) {
            forces_.compute(elastic_, state.x, state.v, r_);
            r_.array() += (guess_ - state.x).array().colwise() * inertia_;
            clear_pinned(model, r_);
            if (iteration == iterations_ - 1) unbalanced = r_.norm();
            global_.solve(r_);
            state.x += r_;
        }
        const Real force = std::max(force_towards(model, guess_), force_towards(model, state.x));
        const Real residual = force > 0 ? unbalanced / force : Real(0);
        set_velocity_from_displacement(model, start_, h, state);
        return {.force_evaluations = 1 + iterations_,
                .iterations = iterations_,
                .residual = residual,
                .tolerance = allowed_imbalance,
                .unconverged = residual <= krylov::drift * allowed_imbalance ? 0 : 1};
    }

private:
    /// Of the external forces, or of those that accelerate the cloth, what may be left unbalanced: in sheets that swing
    /// or hang in the wind, a tenth has come to errors of up to a hundredth.
    static constexpr Real allowed_imbalance = Real(0.05);

    static void clear_pinned(const ClothModel& model, Points& points) {
        for (int axis = 0; axis < 3; ++axis) {
            points.col(axis) = (model.inverse_mass > 0).select(points.col(axis).array(), Real(0));
        }
    }

    /// Makes the guess, and the state where the rounds begin.
    void guess(const ClothModel& model, ClothState& state, Real h) {
        moved_ = state.x + h * state.v;
        inertial_.advance(model, inertia_, state, h);
        guess_ = state.x;
        if (model.air.density > 0) state.x = moved_;
    }

    /// That brings the cloth to x from where the motion alone would lead it [N].
    Real force_towards(const ClothModel& model, const Points& x) {
        r_ = ((x - moved_).array().colwise() * inertia_).matrix();
        clear_pinned(model, r_);
        return r_.norm();
    }

    void keep_springs_of(const ClothModel& model) {
        elastic_ = model;
        elastic_.structural.damping = elastic_.shear.damping = elastic_.bend.damping = 0;
        elastic_.gravity.setZero();
        elastic_.drag = elastic_.air.density = 0;
    }

    /// Slows the springs' ends to where dampers alone would let them get.
    void damp(const ClothModel& model, ClothState& state, Real h) {
        auto springs = spring_stencils(model);
        for (SpringStencil& stencil : springs) stencil.law.stiffness = 0;
        start_ = state.x;
        state.x += h * state.v;
        dampers_.begin(model, inertia_, h);
        dampers_.pass(springs, start_, state.x);
        set_velocity_from_displacement(model, start_, h, state);
        state.x = start_;
    }

    int iterations_;
    InertialGuess inertial_;
    SpringPasses dampers_;
    ForceSweep forces_;
    GlobalMatrix global_;
    ClothModel elastic_;  ///< the model with nothing but its springs' stiffness
    Numbers inertia_;
    Points start_, guess_, moved_, r_;
};

}  // namespace drape
