// Whatever particles want to do within a substep, bounds let no two features meet.

#include "drape/contact/motion_bounds.h"

#include <gtest/gtest.h>

#include "support/cloths.h"
#include "support/crossings.h"

namespace drape {
namespace {

using test::crossings;

/// Two cloths that come near each other and themselves.
struct TwoCloths {
    std::array<ClothModel, 2> models;
    std::array<ClothState, 2> states;
    std::array<CellBoxes, 2> boxes;

    [[nodiscard]] BoxedCloth boxed(int number) {
        const auto c = static_cast<std::size_t>(number);
        boxes[c].build(models[c].grid, states[c].x);
        return {{number, models[c].grid, states[c].x}, boxes[c]};
    }

    [[nodiscard]] std::int64_t all_crossings() {
        const BoxedCloth first = boxed(0), second = boxed(1);
        return crossings(first, first) + crossings(second, second) + crossings(first, second);
    }

    [[nodiscard]] std::vector<NearPair> pairs_within(Real margin) {
        const BoxedCloth all[] = {boxed(0), boxed(1)};
        std::vector<NearPair> pairs;
        for (const auto& [first, second] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 1)}) {
            const BoxedCloth &one = all[first], &two = all[second];
            find_near_pairs(one, two, margin, {{all_cells(one.cloth.grid), all_cells(two.cloth.grid)}}, pairs);
        }
        return pairs;
    }
};

/// Folded in waves that nearly touch, one sheet close above the other: without a crossing.
TwoCloths near_cloths(std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(0, 1);
    TwoCloths cloths;
    const Real gap = Real(0.002) + Real(0.01) * unit(random), wave = Real(0.05) * unit(random);
    for (std::size_t c = 0; c < 2; ++c) {
        ClothParameters parameters;
        parameters.particles = {10 + static_cast<int>(c), 9};
        cloths.models[c] = make_cloth_model(parameters);
        cloths.states[c] = make_rest_state(parameters);
        Points& x = cloths.states[c].x;
        for (Eigen::Index p = 0; p < x.rows(); ++p) {
            x(p, 1) = wave * std::sin(9 * x(p, 0)) + gap * static_cast<Real>(c) + Real(1e-3) * unit(random) * gap;
            x(p, 0) *= Real(0.4);
        }
    }
    return cloths;
}

/// Every particle goes its own way, by up to some length.
void move_wildly(ClothState& state, Real length, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    for (Eigen::Index k = 0; k < state.x.size(); ++k) {
        state.v.data()[k] = unit(random);
        state.x.data()[k] += length * state.v.data()[k];
    }
}

TEST(MotionBounds, LetNoTwoFeaturesMeetHoweverParticlesMove) {
    std::mt19937 random(8);
    std::int64_t without = 0, held = 0;
    for (int trial = 0; trial < 40; ++trial) {
        TwoCloths cloths = near_cloths(random);
        if (cloths.all_crossings() > 0) continue;
        const Real margin = Real(0.05);
        const std::array counts{cloths.models[0].grid.particles(), cloths.models[1].grid.particles()};
        for (int substep = 0; substep < 4; ++substep) {
            MotionBounds bounds;
            const std::vector<Real> reaches(static_cast<std::size_t>(counts[0] + counts[1]), margin / 2);
            bounds.start(counts, reaches);
            for (const NearPair& pair : cloths.pairs_within(margin)) bounds.tighten(pair);
            const std::array before{cloths.states[0].x, cloths.states[1].x};
            for (ClothState& state : cloths.states) move_wildly(state, Real(0.05), random);
            without += cloths.all_crossings();
            for (int c = 0; c < 2; ++c) {
                const auto k = static_cast<std::size_t>(c);
                held += bounds.hold_back(c, cloths.models[k], before[k], cloths.states[k]).particles;
            }
            ASSERT_EQ(cloths.all_crossings(), 0) << "trial " << trial;
        }
    }
    EXPECT_GT(without, 10'000);
    EXPECT_GT(held, 10'000);
}

TEST(MotionBounds, TellWhatTheyTake) {
    TwoCloths cloths;
    for (std::size_t c = 0; c < 2; ++c) {
        ClothParameters parameters;
        parameters.particles = {2, 2};
        parameters.mass = Real(0.4);
        cloths.models[c] = make_cloth_model(parameters);
        cloths.states[c] = make_rest_state(parameters);
        cloths.states[c].v.setZero();
    }
    cloths.states[1].x.col(1).array() = Real(0.01);
    const std::array counts{4, 4};
    MotionBounds bounds;
    const std::vector<Real> reaches(8, Real(0.5));
    bounds.start(counts, reaches);
    for (const NearPair& pair : cloths.pairs_within(Real(0.1))) bounds.tighten(pair);
    const Points before = cloths.states[0].x;
    cloths.states[0].x(2, 1) += Real(0.009);
    cloths.states[0].v(2, 1) = 3;
    const BoundedMotion taken = bounds.hold_back(0, cloths.models[0], before, cloths.states[0]);
    EXPECT_EQ(taken.particles, 1);
    EXPECT_NEAR(cloths.states[0].x(2, 1), 0.0045, 1e-15);
    EXPECT_NEAR(taken.longest, 0.0045, 1e-15);
    EXPECT_NEAR(cloths.states[0].v(2, 1), 1.5, 1e-14);
    EXPECT_NEAR(taken.energy, 0.05 * (9 - 1.5 * 1.5), 1e-14);
    EXPECT_NEAR(taken.momentum.y(), 0.1 * 1.5, 1e-15);
}

}  // namespace
}  // namespace drape
