// A build may be left out only where brute force finds no contact either.

#include "drape/bounds/separation.h"

#include <gtest/gtest.h>

#include "drape/bounds/leaf_copies.h"
#include "drape/contact/contact.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

/// How a run went in which builds were left out wherever a rule said so.
struct Count {
    int steps = 0, skips = 0, wrong = 0;
};

/// What a rule may look at.
struct Moment {
    const BroadPhase& tree;
    const Separation& separation;
    const Points &x, &built_from;
    std::span<const Ball> balls, balls_at_build;
    Real thickness;
};

/// Cloths that wobble and drift, two balls that fly by, leap and swell, and a thickness that changes now and then.
template <class Rule>
Count count_skips(const BroadPhaseParameters& parameters, Rule may_skip) {
    Count count;
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> unit(-1, 1);
        const auto direction = [&] { return Vec3(unit(random), unit(random), unit(random)); };
        const Grid grid{12, 9};
        const auto tree = make_broad_phase(parameters, grid),
                   brute = make_broad_phase({.volume = VolumeKind::Brute}, grid);
        Separation separation(grid, Kernels::Vector);
        Points x = test::random_cloth(grid, random), built_from = x;
        std::vector<Ball> balls(2), balls_at_build;
        for (Ball& ball : balls)
            ball = {.centre = Real(1.2) * direction(), .radius = Real(0.1), .velocity = direction() / 50};
        Vec3 drift = direction() / 50;
        Real thickness = 0;
        for (int step = 0; step < 400; ++step, ++count.steps) {
            if (random() % 40 == 0) balls[random() % 2].centre = Real(1.2) * direction();
            if (random() % 40 == 0) balls[random() % 2].radius = Real(0.05) * std::exp(Real(3.4) * unit(random));
            if (random() % 60 == 0) thickness = Real(0.1) * std::abs(unit(random));
            if (random() % 40 == 0) drift = -drift;
            for (Ball& ball : balls) ball.centre += ball.velocity;
            x.rowwise() += drift.transpose();
            x += Real(0.01) * Points::NullaryExpr(x.rows(), 3, [&] { return unit(random); });

            if (may_skip(Moment{*tree, separation, x, built_from, balls, balls_at_build, thickness})) {
                ++count.skips;
                Candidates all;
                std::vector<int> touched;
                brute->query(balls[0], all);
                bool touching = false;
                for (const Ball& ball : balls) {
                    find_touched_triangles(grid, x, ball, thickness, all.cells, touched, Kernels::Vector);
                    touching |= !touched.empty();
                }
                count.wrong += touching ? 1 : 0;
                continue;
            }
            tree->build(x);
            separation.renew(*tree, x, balls, thickness);
            built_from = x;
            balls_at_build = balls;
        }
    }
    return count;
}

bool proven(const Moment& m) { return m.separation.holds(m.tree, m.x, m.balls, m.thickness); }

/// A planted fault's rule: the tree as the separation asks it, but about other balls or another displacement.
bool none_reaches(const Moment& m, std::span<const Ball> balls, Real displacement) {
    return !m.balls_at_build.empty() && std::ranges::none_of(balls, [&](const Ball& ball) {
        return m.tree.may_touch(grown(ball, m.thickness), displacement);
    });
}

TEST(Separation, NeverHoldsWhereAnythingTouches) {
    for (const VolumeKind volume : {VolumeKind::Sphere, VolumeKind::Aabb}) {
        for (const UpdateKind update : test::all_updates()) {
            const Count count = count_skips({.volume = volume, .update = update, .leaf_cells = 3}, proven);
            EXPECT_EQ(count.wrong, 0);
            EXPECT_GT(count.skips, count.steps / 20);
            EXPECT_LT(count.skips, count.steps);
        }
    }
}

TEST(Separation, WouldBeWrongIfItForgotTheClothsDisplacement) {
    EXPECT_GT(count_skips({}, [](const Moment& m) { return none_reaches(m, m.balls, 0); }).wrong, 10);
}

TEST(Separation, WouldBeWrongIfItForgotThatBallsSwell) {
    const auto with_old_radii = [](const Moment& m) {
        std::vector<Ball> balls(m.balls.begin(), m.balls.end());
        for (std::size_t b = 0; b < m.balls_at_build.size(); ++b) balls[b].radius = m.balls_at_build[b].radius;
        return none_reaches(m, balls, largest_displacement(m.x, m.built_from, Kernels::Vector));
    };
    EXPECT_GT(count_skips({}, with_old_radii).wrong, 10);
}

TEST(Separation, WouldBeWrongIfItForgotThatBallsLeap) {
    const auto with_old_places = [](const Moment& m) {
        return none_reaches(m, m.balls_at_build, largest_displacement(m.x, m.built_from, Kernels::Vector));
    };
    EXPECT_GT(count_skips({}, with_old_places).wrong, 10);
}

TEST(Separation, HoldsNoLongerOnceForgotten) {
    const Grid grid{4, 4};
    std::mt19937 random(1);
    const Points x = test::random_cloth(grid, random);
    const std::vector<Ball> far{{.centre = Vec3(9, 0, 0), .radius = 1}};
    const auto tree = make_broad_phase({}, grid);
    tree->build(x);
    Separation separation(grid, Kernels::Vector);
    EXPECT_FALSE(separation.holds(*tree, x, far, 0)) << "nothing was proven yet";
    separation.renew(*tree, x, far, 0);
    EXPECT_TRUE(separation.holds(*tree, x, far, 0));
    EXPECT_FALSE(separation.holds(*tree, x, far, 8)) << "so thick a cloth touches";
    separation.forget();
    EXPECT_FALSE(separation.holds(*tree, x, far, 0));
}

}  // namespace
}  // namespace drape
