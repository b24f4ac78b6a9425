// Whatever particles want to do within a substep, zones let no two features meet, and keep their momentum.

#include "drape/contact/impact_zones.h"

#include <gtest/gtest.h>

#include "support/cloths.h"
#include "support/scene_crossings.h"

namespace drape {
namespace {

/// Distance that cloth is to keep [m].
constexpr Real min_gap = Real(1e-6);

/// Two cloths that come near each other and themselves.
struct TwoCloths {
    std::array<ClothModel, 2> models;
    std::array<ClothState, 2> states;
    std::array<Points, 2> before;
    std::array<CellBoxes, 2> boxes;
    std::array<std::vector<Real>, 2> reaches;

    [[nodiscard]] BoxedCloth boxed(int number, Real margin) {
        const auto c = static_cast<std::size_t>(number);
        reaches[c].assign(static_cast<std::size_t>(models[c].grid.particles()), margin / 2);
        boxes[c].build(models[c].grid, states[c].x, reaches[c]);
        return {{number, models[c].grid, states[c].x}, boxes[c], reaches[c]};
    }

    [[nodiscard]] std::int64_t all_crossings() { return test::SceneCrossings().count(in_contact()); }

    [[nodiscard]] std::vector<NearPair> pairs_within(Real margin) {
        const BoxedCloth all[] = {boxed(0, margin), boxed(1, margin)};
        std::vector<NearPair> pairs;
        for (const auto& [first, second] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 1)}) {
            const BoxedCloth &one = all[first], &two = all[second];
            const LeafPair all_of_both{all_cells(one.cloth.grid), all_cells(two.cloth.grid)};
            find_near_pairs(one, two, {&all_of_both, 1}, pairs);
        }
        return pairs;
    }

    [[nodiscard]] std::array<ClothInContact, 2> in_contact() {
        return {ClothInContact{models[0], before[0], states[0]}, ClothInContact{models[1], before[1], states[1]}};
    }

    [[nodiscard]] std::array<std::size_t, 3> first_particles() const {
        const auto particles = [&](std::size_t c) { return static_cast<std::size_t>(models[c].grid.particles()); };
        return {0, particles(0), particles(0) + particles(1)};
    }

    /// Holds back what would meet.
    /// @return how many particles
    std::int64_t prevent_crossing(const std::vector<NearPair>& pairs) {
        ImpactZones zones;
        const auto cloths = in_contact();
        const auto first = first_particles();
        if (!zones.find(pairs, cloths, first, min_gap)) return 0;
        zones.prevent_crossing(pairs);
        return zones.particles();
    }

    [[nodiscard]] Vec3 momentum() const {
        return models[0].particle_mass * states[0].v.colwise().sum().transpose() +
               models[1].particle_mass * states[1].v.colwise().sum().transpose();
    }
};

/// Folded in waves that nearly touch, one sheet close above the other: without a crossing.
TwoCloths near_cloths(std::mt19937& random, Pins::Kind pins = Pins::Kind::None) {
    std::uniform_real_distribution<Real> unit(0, 1);
    TwoCloths cloths;
    const Real gap = Real(0.002) + Real(0.01) * unit(random), wave = Real(0.05) * unit(random);
    for (std::size_t c = 0; c < 2; ++c) {
        ClothParameters parameters;
        parameters.particles = {10 + static_cast<int>(c), 9};
        parameters.pinned.kind = pins;
        cloths.models[c] = make_cloth_model(parameters);
        cloths.states[c] = make_rest_state(parameters);
        Points& x = cloths.states[c].x;
        for (Eigen::Index p = 0; p < x.rows(); ++p) {
            x(p, 1) = wave * std::sin(9 * x(p, 0)) + gap * static_cast<Real>(c) + Real(1e-3) * unit(random) * gap;
            x(p, 0) *= Real(0.4);
        }
        cloths.before[c] = x;
    }
    return cloths;
}

/// Every free particle goes its own way, by up to some length, and all go another way together.
void move_wildly(TwoCloths& cloths, Real length, const Vec3& together, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    for (std::size_t c = 0; c < 2; ++c) {
        ClothState& state = cloths.states[c];
        cloths.before[c] = state.x;
        for (int p = 0; p < cloths.models[c].grid.particles(); ++p) {
            if (cloths.models[c].pinned(p)) continue;
            state.v.row(p) = Vec3(unit(random), unit(random), unit(random)).transpose();
            state.x.row(p) += length * state.v.row(p) + together.transpose();
        }
    }
}

class Zones : public testing::TestWithParam<Pins::Kind> {};

INSTANTIATE_TEST_SUITE_P(All, Zones, testing::Values(Pins::Kind::None, Pins::Kind::Row),
                         [](const auto& param) { return param.index == 0 ? "Free" : "Pinned"; });

TEST_P(Zones, LetNoTwoFeaturesMeetHoweverParticlesMove) {
    std::mt19937 random(8);
    std::int64_t without = 0, held = 0;
    for (int trial = 0; trial < 40; ++trial) {
        TwoCloths cloths = near_cloths(random, GetParam());
        if (cloths.all_crossings() > 0) continue;
        for (int substep = 0; substep < 4; ++substep) {
            const Real length = Real(0.02) / static_cast<Real>(1 + trial % 5);
            const std::vector<NearPair> pairs = cloths.pairs_within(2 * std::sqrt(Real(3)) * length + Real(1e-3));
            move_wildly(cloths, length, Vec3::Zero(), random);
            without += cloths.all_crossings();
            const Vec3 momentum = cloths.momentum();
            held += cloths.prevent_crossing(pairs);
            ASSERT_EQ(cloths.all_crossings(), 0) << "trial " << trial;
            if (GetParam() == Pins::Kind::None) {
                ASSERT_LT((momentum - cloths.momentum()).norm(), 1e-13);
            }
            for (std::size_t c = 0; c < 2; ++c) {
                for (int p = 0; p < cloths.models[c].grid.particles(); ++p) {
                    if (!cloths.models[c].pinned(p)) continue;
                    ASSERT_EQ(cloths.states[c].x.row(p), cloths.before[c].row(p)) << "a pin has moved";
                }
            }
        }
    }
    EXPECT_GT(without, 1'000);
    EXPECT_GT(held, 1'000);
}

TEST(ImpactZones, AreNoneWhereAllMoveTogether) {
    std::mt19937 random(9);
    TwoCloths cloths = near_cloths(random);
    const std::vector<NearPair> pairs = cloths.pairs_within(Real(0.02));
    ASSERT_GT(pairs.size(), 100u);
    move_wildly(cloths, 0, {3, -40, 7}, random);
    EXPECT_EQ(cloths.prevent_crossing(pairs), 0);
}

/// Two squares of four particles, the second above the first.
TwoCloths squares(Real above) {
    TwoCloths cloths;
    for (std::size_t c = 0; c < 2; ++c) {
        ClothParameters parameters;
        parameters.particles = {2, 2};
        parameters.mass = Real(0.4);
        cloths.models[c] = make_cloth_model(parameters);
        cloths.states[c] = make_rest_state(parameters);
        cloths.states[c].v.setZero();
    }
    cloths.states[1].x.col(1).array() = above;
    for (std::size_t c = 0; c < 2; ++c) cloths.before[c] = cloths.states[c].x;
    return cloths;
}

TEST(ImpactZones, GoOnWithTheirMeanMotion) {
    // The second square falls through the first: both go on together, with a tenth to a fifth of the gap left
    TwoCloths cloths = squares(Real(0.01));
    const std::vector<NearPair> pairs = cloths.pairs_within(Real(0.1));
    cloths.states[1].x.col(1).array() -= Real(0.03);
    cloths.states[1].v.col(1).array() = -3;
    EXPECT_EQ(cloths.prevent_crossing(pairs), 8);
    EXPECT_NEAR(cloths.momentum().y(), -0.4 * 3, 1e-15);
    const Real gap = cloths.states[1].x(0, 1) - cloths.states[0].x(0, 1);
    EXPECT_GE(gap, 0.1 * 0.01 - 1e-15);
    EXPECT_LE(gap, 0.2 * 0.01);
    EXPECT_NEAR(cloths.states[0].x(0, 1) + cloths.states[1].x(0, 1), 0.01 - 0.03, 1e-15) << "the centre of mass";
    const Real part = (Real(0.01) - gap) / Real(0.03);
    EXPECT_NEAR(cloths.states[1].v(0, 1) - cloths.states[0].v(0, 1), -3 * part, 1e-12);
}

}  // namespace
}  // namespace drape
