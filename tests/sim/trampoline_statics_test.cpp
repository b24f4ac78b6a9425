// The sheet of `trampoline`, with its ball and without, hangs where statics puts it.

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <cmath>
#include <set>

#include "drape/model/stencils.h"
#include "drape/sim/scene.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

/// Springs and weights in equilibrium, by Newton's method on their energy, with nothing of the simulation but the
/// springs' stiffnesses and rest lengths.
class Statics {
public:
    /// @param held particles that do not move
    Statics(const ClothModel& model, std::set<int> held) : model_(model), held_(std::move(held)) {}

    /// What springs and weight pull each particle with, at most by `balance` if it is free, once `solve` is through
    /// [N].
    [[nodiscard]] const Eigen::VectorXd& forces() const { return forces_; }

    /// Newton's method, held back where the energy would rise, for sheets that could buckle.
    /// @param x n x 3, where to start [m]
    /// @return where nothing pulls any more
    Points solve(Points x) {
        constexpr double balance = 1e-8;  // N
        double stiffer = 1;               // N/m
        double energy = energy_of(x);
        for (int round = 0; round < 300; ++round) {
            linearise(x, stiffer);
            Eigen::VectorXd free = forces_;
            for (const int p : held_) free.segment<3>(3 * p).setZero();
            if (free.lpNorm<Eigen::Infinity>() < balance) return x;
            const Points there = moved(x, solver_.solve(free));
            const double now = energy_of(there);
            const bool is_lower = now <= energy + 1e-14;
            stiffer *= is_lower ? 0.25 : 8;
            if (is_lower) x = there, energy = now;
        }
        ADD_FAILURE() << "no equilibrium, but " << forces_.lpNorm<Eigen::Infinity>() << " N";
        return x;
    }

private:
    struct Stretched {
        Eigen::Vector3d along;  ///< of length 1
        double length, tension;
    };

    static Stretched stretch(const SpringStencil& springs, const Points& x, int a, int b) {
        const Eigen::Vector3d d = (x.row(b) - x.row(a)).transpose().template cast<double>();
        const double length = d.norm();
        return {d / length, length,
                static_cast<double>(springs.law.stiffness) * (length - static_cast<double>(springs.rest_length))};
    }

    [[nodiscard]] Points moved(const Points& x, const Eigen::VectorXd& way) const {
        Points there = x;
        for (int p = 0; p < model_.grid.particles(); ++p) {
            there.row(p) += way.segment<3>(3 * p).transpose().template cast<Real>();
        }
        return there;
    }

    [[nodiscard]] double energy_of(const Points& x) const {
        const double weight = static_cast<double>(model_.particle_mass) * static_cast<double>(model_.gravity.norm());
        double energy = weight * x.col(1).template cast<double>().sum();
        for (const SpringStencil& springs : spring_stencils(model_)) {
            springs.for_each(model_.grid, [&](int a, int b) {
                const Stretched now = stretch(springs, x, a, b);
                energy += now.tension * (now.length - static_cast<double>(springs.rest_length)) / 2;
            });
        }
        return energy;
    }

    /// @param stiffer how much stiffer than the springs are each particle is held [N/m]
    void linearise(const Points& x, double stiffer) {
        const int n = 3 * model_.grid.particles();
        std::vector<Eigen::Triplet<double>> entries;
        forces_.setZero(n);
        for (int p = 0; p < model_.grid.particles(); ++p) {
            forces_[3 * p + 1] =
                -static_cast<double>(model_.particle_mass) * static_cast<double>(model_.gravity.norm());
            for (int k = 0; k < 3; ++k) entries.emplace_back(3 * p + k, 3 * p + k, held_.contains(p) ? 1e12 : stiffer);
        }
        for (const SpringStencil& springs : spring_stencils(model_)) {
            springs.for_each(model_.grid, [&](int a, int b) {
                const auto [along, length, tension] = stretch(springs, x, a, b);
                forces_.segment<3>(3 * a) += tension * along;
                forces_.segment<3>(3 * b) -= tension * along;
                const double across = tension / length;
                const Eigen::Matrix3d block =
                    (static_cast<double>(springs.law.stiffness) - across) * along * along.transpose() +
                    across * Eigen::Matrix3d::Identity();
                for (int i = 0; i < 3; ++i) {
                    for (int j = 0; j < 3; ++j) {
                        for (const auto& [row, column, sign] : {std::tuple(a, a, 1), {b, b, 1}, {a, b, -1}, {b, a, -1}})
                            entries.emplace_back(3 * row + i, 3 * column + j, sign * block(i, j));
                    }
                }
            });
        }
        Eigen::SparseMatrix<double> stiffness(n, n);
        stiffness.setFromTriplets(entries.begin(), entries.end());
        solver_.compute(stiffness);
    }

    const ClothModel& model_;
    std::set<int> held_;
    Eigen::VectorXd forces_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

std::set<int> pins_of(const ClothModel& model) {
    std::set<int> pins;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) pins.insert(p);
    }
    return pins;
}

/// The shipped scene after so long that it rests.
Simulation trampoline_at_rest(bool with_ball) {
    Settings settings = load_scene("trampoline");
    if (!with_ball) settings.balls.clear();
    Simulation simulation("trampoline", std::move(settings));
    while (!simulation.report().asleep && simulation.report().time < 20) simulation.step();
    EXPECT_TRUE(simulation.report().asleep);
    return simulation;
}

double farthest_apart(const Points& a, const Points& b) {
    return static_cast<double>((a - b).rowwise().norm().maxCoeff());
}

TEST(TrampolineStatics, TheSheetSagsByItsOwnWeightAsTheySay) {
    const Simulation simulation = trampoline_at_rest(false);
    const Cloth& cloth = simulation.cloths()[0];
    Statics statics(cloth.model, pins_of(cloth.model));
    const Points there = statics.solve(cloth.state.x);
    EXPECT_GT(cloth.state.x.col(1).maxCoeff() - cloth.state.x.col(1).minCoeff(), 0.02);
    EXPECT_LT(farthest_apart(cloth.state.x, there), 1e-4);
}

/// What the ball touches is held where it is; statics has the places of all others, and the forces that hold these.
TEST(TrampolineStatics, TheSheetSagsUnderTheBallAsTheySay) {
    const Simulation simulation = trampoline_at_rest(true);
    const Cloth& cloth = simulation.cloths()[0];
    std::set<int> touched, held = pins_of(cloth.model);
    for (const ContactRow& contact : simulation.contacts()) {
        for (const RowParticle& p : contact.moved()) {
            if (p.weight > 0) touched.insert(p.particle);
        }
    }
    ASSERT_FALSE(touched.empty());
    held.insert(touched.begin(), touched.end());
    Statics statics(cloth.model, held);
    const Points there = statics.solve(cloth.state.x);
    EXPECT_GT(cloth.state.x(0, 1) - cloth.state.x.col(1).minCoeff(), 0.05);
    EXPECT_LT(farthest_apart(cloth.state.x, there), 1e-4);
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (const int p : touched) pull += statics.forces().segment<3>(3 * p);
    const double weight = static_cast<double>(simulation.settings().balls[0].mass) * 9.81;
    EXPECT_NEAR(pull.y(), weight, 0.01 * weight);
    EXPECT_NEAR(std::hypot(pull.x(), pull.z()), 0, 0.01 * weight);
}

}  // namespace
}  // namespace drape
