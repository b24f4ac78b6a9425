#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "drape/integrate/stability.h"
#include "drape/model/jacobian.h"

namespace drape {

/// A vibration y of a cloth, as its Rayleigh quotients.
struct Mode {
    Real stiffness = 0;  ///< y'Ky / y'My [1/s^2], the square of its frequency
    Real damping = 0;    ///< y'Dy / y'My [1/s]
    // What y is short of being an eigenvector of both, for y of length 1 by mass
    Real stiffness_variance = 0;  ///< |Ky - ky|^2 [1/s^4]
    Real damping_variance = 0;    ///< |Dy - dy|^2 [1/s^2]
    Real covariance = 0;          ///< (Ky - ky)'(Dy - dy) [1/s^3]
    Points shape = {};            ///< y, n x 3, its norm is 1; exactly 0 at pins
};

/// Looks for the vibration of the free particles that has the largest a k + b d, where k and d are those of `Mode`.
///
/// Locally optimal conjugate gradients: each turn takes the best vector of the space of y, the gradient r at y, and the
/// last direction p. It comes as near as Lanczos' method in as many products, needs three vectors, and has y at hand.
/// Invariant: y, p and r have norm 1 or 0 and are orthogonal.
/// @cite knyazev2001
class ModeSearch {
public:
    /// Starts at a random vector, always the same.
    ModeSearch(const ClothModel& model, const ClothState& state, Kernels kernels)
        : model_(model), jacobian_(model.grid, Hessian::Clamped, kernels) {
        jacobian_.linearise(model, state.x, state.v, true);
        for (Points* points : {&y_, &r_, &p_, &ay_, &ar_, &ap_}) points->setZero(model.grid.particles(), 3);
    }

    /// Goes on from the vector that was found last, with a little noise; ends after `turns`, or when the turns no
    /// longer gain anything.
    /// @return a k + b d of what was found
    Real maximise(Real a, Real b, int turns) {
        constexpr int patience = 6;
        constexpr Real worthwhile = Real(1e-5);
        add_noise(y_.isZero(0) ? Real(1) : Real(0.3));
        p_.setZero();
        ap_.setZero();
        apply(a, b, y_, ay_);
        normalise(y_, ay_);
        Real height = dot(y_, ay_);
        Real before = height;
        for (int turn = 1; turn <= turns; ++turn) {
            r_ = ay_ - height * y_;
            normalise(r_, ar_);
            apply(a, b, r_, ar_);

            // The last direction, without what y and r already have of it
            const Real in_y = dot(p_, y_), in_r = dot(p_, r_);
            p_ -= in_y * y_ + in_r * r_;
            ap_ -= in_y * ay_ + in_r * ar_;
            normalise(p_, ap_);

            take_best();
            height = dot(y_, ay_);
            if (turn % patience != 0) continue;
            if (!(height - before > worthwhile * std::abs(height))) break;
            before = height;
        }
        return height;
    }

    /// What was found last.
    [[nodiscard]] Mode mode() {
        apply(1, 0, y_, ar_);
        apply(0, 1, y_, ap_);
        const Real k = dot(y_, ar_), d = dot(y_, ap_);
        ar_ -= k * y_;
        ap_ -= d * y_;
        return {std::max(k, Real(0)), std::max(d, Real(0)), ar_.squaredNorm(), ap_.squaredNorm(), dot(ar_, ap_), y_};
    }

private:
    static Real dot(const Points& a, const Points& b) { return a.reshaped().dot(b.reshaped()); }

    /// Scales a vector and its image to norm 1; zero if there is nothing left of it.
    static void normalise(Points& u, Points& image) {
        const Real norm = u.norm();
        const Real scale = norm > std::sqrt(std::numeric_limits<Real>::min()) ? 1 / norm : Real(0);
        u *= scale;
        image *= scale;
    }

    void apply(Real a, Real b, const Points& u, Points& out) const {
        out.setZero();
        jacobian_.add_product(a, b, u, out);
        for (int axis = 0; axis < 3; ++axis) out.col(axis).array() *= model_.inverse_mass;
    }

    void add_noise(Real size) {
        std::mt19937 random(1);
        const Real scale = size / (std::sqrt(static_cast<Real>(y_.size())) * static_cast<Real>(std::mt19937::max()));
        for (Eigen::Index p = 0; p < y_.rows(); ++p) {
            for (int axis = 0; axis < 3; ++axis) {
                const Real draw = 2 * static_cast<Real>(random()) - static_cast<Real>(std::mt19937::max());
                if (!model_.pinned(static_cast<int>(p))) y_(p, axis) += scale * draw;
            }
        }
    }

    void take_best() {
        Eigen::Matrix<Real, 3, 3> products;
        products << dot(y_, ay_), 0, 0,                //
            dot(r_, ay_), dot(r_, ar_), 0,             //
            dot(p_, ay_), dot(p_, ar_), dot(p_, ap_);  // the solver reads the lower half
        // A direction of which nothing is left must not be taken for one of height 0, where all others are below
        const Real below = products(0, 0) - std::abs(products(0, 0)) - 1;
        if (r_.isZero(0)) products(1, 1) = below;
        if (p_.isZero(0)) products(2, 2) = below;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>> solver(products);
        const Eigen::Matrix<Real, 3, 1> best = solver.eigenvectors().col(2);

        // What is added to y is the next direction
        p_ = best[1] * r_ + best[2] * p_;
        ap_ = best[1] * ar_ + best[2] * ap_;
        y_ = best[0] * y_ + p_;
        ay_ = best[0] * ay_ + ap_;
        normalise(y_, ay_);
    }

    const ClothModel& model_;
    Jacobian jacobian_;
    Points y_, r_, p_, ay_, ar_, ap_;
};

/// Finds the least value of a function of k and d over all vibrations of a cloth.
///
/// The pairs (k, d) of all vibrations, complex ones included, fill a convex set: the numerical range of K and D. Each
/// search for the largest a k + b d gives a line that this set lies behind, and a point at which it touches it. The
/// lines enclose the set from outside, the points span it from within. Where the least value outside is well below
/// that within, a search across the chord of the two neighbouring points cuts that corner off: both polygons close in
/// on each other quadratically.
/// @cite johnson1978
class LimitSearch {
public:
    /// @param search for the cloth at its state
    /// @param least_damping no vibration has less [1/s]
    /// @param longest the step of a vibration, by its k and d; it falls as both grow by s^2 and s
    LimitSearch(ModeSearch& search, double least_damping, std::function<double(double, double)> longest)
        : search_(search), longest_(std::move(longest)) {
        search.maximise(1, 0, turns);
        const Mode stiffest = search.mode();
        search.maximise(0, 1, turns);
        const Mode most_damped = search.mode();
        const auto unit = [](Real a, Real b) { return a > 0 || b > 0 ? static_cast<double>(std::max(a, b)) : 1.0; };
        stiffness_unit_ = unit(stiffest.stiffness, most_damped.stiffness);
        damping_unit_ = unit(stiffest.damping, most_damped.damping);

        // Two sides are known beforehand, and stand near this corner
        const Pair softest{0, least_damping / damping_unit_};
        sides_ = {{0, -1, -softest.d, softest}, {1, 0, 0, {}}, {0, 1, 0, {}}, {-1, 0, 0, softest}};
        add(stiffest, 1);
        add(most_damped, 2);
    }

    /// @param decides whether the limit of a vibration is that of the cloth
    /// @return flagged `at_least` unless a vibration was found that has it; the shape of the shortest that was found
    LimitingMode find(const std::function<bool(const Mode&)>& decides) {
        constexpr int most_cuts = 12;
        constexpr double precision = 5e-4;
        Least outside;
        for (int cuts = 0;; ++cuts) {
            Least within;
            outside = {};
            measure(outside, within);
            if (outside.value >= (1 - precision) * within.value || cuts == most_cuts || !cut(outside.side)) break;
        }

        // A vibration that itself has as short a limit decides
        LimitingMode best;
        double shortest = std::numeric_limits<double>::infinity();
        bool attained = false;
        for (const Mode& mode : found_) {
            const auto k = static_cast<double>(mode.stiffness), d = static_cast<double>(mode.damping);
            const double step = longest_(k, d);
            if (!(step < shortest)) continue;
            shortest = step;
            best = {limit_at(k, d, step), mode.shape};
            attained = decides(mode);
        }
        if (attained && outside.value >= (1 - 2 * precision) * shortest) return best;
        best.limit = limit_at(outside.at.k * stiffness_unit_, outside.at.d * damping_unit_, outside.value);
        best.limit.at_least = true;
        return best;
    }

private:
    static constexpr int turns = 200;

    /// k and d, in units of the largest of each.
    struct Pair {
        double k = 0, d = 0;
    };

    /// A line that no pair lies beyond: a k + b d <= height.
    struct Side {
        double a, b;
        double height;
        Pair touch;  ///< where the set reaches it, or nearly

        [[nodiscard]] double of(const Pair& p) const { return a * p.k + b * p.d; }
    };

    /// The least of some values, and where it is.
    struct Least {
        double value = std::numeric_limits<double>::infinity();
        Pair at = {};
        std::size_t side = 0;  ///< the corner is that of this side and the next

        void note(double other, const Pair& p, std::size_t number) {
            if (other < value) *this = {other, p, number};
        }
    };

    static StepLimit limit_at(double k, double d, double step) {
        const double omega = std::sqrt(k), zeta = omega > 0 ? d / (2 * omega) : 0;
        return {static_cast<Real>(omega), static_cast<Real>(zeta), static_cast<Real>(step)};
    }

    static Pair between(const Pair& p, const Pair& q, double s) {
        return {p.k + s * (q.k - p.k), p.d + s * (q.d - p.d)};
    }

    /// Where two sides meet.
    static Pair corner(const Side& p, const Side& q) {
        const double area = p.a * q.b - p.b * q.a;
        if (!(area > 1e-12)) return p.touch;  // one side, found twice
        return {(p.height * q.b - q.height * p.b) / area, (p.a * q.height - q.a * p.height) / area};
    }

    /// The least value on the polygon outside and on that within.
    void measure(Least& outside, Least& within) const {
        constexpr int samples = 4;
        for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
            const Pair from = sides_[i].touch, to = sides_[i + 1].touch, tip = corner(sides_[i], sides_[i + 1]);
            for (int n = 0; n <= samples; ++n) {
                const double s = static_cast<double>(n) / samples;
                for (const Pair& p : {between(from, tip, s), between(to, tip, s)}) outside.note(limit_of(p), p, i);
                for (const Pair& p : {between(from, to, s / 2), between(to, from, s / 2)}) {
                    within.note(limit_of(p), p, i);
                }
            }
        }
    }

    /// Cuts a corner off.
    /// @return false if there is nothing to cut
    bool cut(std::size_t number) {
        const Pair from = sides_[number].touch, to = sides_[number + 1].touch;
        const double a = to.d - from.d, b = from.k - to.k, size = std::abs(a) + std::abs(b);
        if (!(size > 1e-9)) return false;
        search_.maximise(static_cast<Real>(a / (size * stiffness_unit_)), static_cast<Real>(b / (size * damping_unit_)),
                         turns);
        const auto place = sides_.begin() + static_cast<std::ptrdiff_t>(number) + 1;
        sides_.insert(place, Side{a / size, b / size, -std::numeric_limits<double>::infinity(), {}});
        add(search_.mode(), number + 1);
        return true;
    }

    [[nodiscard]] Pair pair_of(const Mode& mode) const {
        return {static_cast<double>(mode.stiffness) / stiffness_unit_,
                static_cast<double>(mode.damping) / damping_unit_};
    }
    [[nodiscard]] double limit_of(const Pair& p) const {
        return longest_(std::max(p.k, 0.0) * stiffness_unit_, std::max(p.d, 0.0) * damping_unit_);
    }

    /// Takes a vibration for that at which the set reaches a side. A search may have ended a little early: what another
    /// one has found moves the side out.
    void add(const Mode& mode, std::size_t number) {
        found_.push_back(mode);
        sides_[number].touch = pair_of(mode);
        for (Side& side : sides_) {
            for (const Mode& known : found_) side.height = std::max(side.height, side.of(pair_of(known)));
        }
    }

    ModeSearch& search_;
    std::function<double(double, double)> longest_;
    double stiffness_unit_ = 1, damping_unit_ = 1;
    std::vector<Side> sides_;  ///< counter-clockwise, from that of the least damping to that of no stiffness
    std::vector<Mode> found_;
};

}  // namespace drape
