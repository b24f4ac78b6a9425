#include "drape/model/stretch_limit.h"

#include <gtest/gtest.h>

#include "drape/model/energy.h"
#include "support/allocations.h"
#include "support/cloths.h"

namespace drape {
namespace {

constexpr Real limit = Real(0.1), round_off = Real(1e-12);

ClothParameters limited_sheet(const Grid& grid, Pins::Kind pinned = Pins::Kind::None) {
    ClothParameters parameters;
    parameters.particles = grid;
    parameters.height = Real(1.3);
    parameters.pinned.kind = pinned;
    parameters.stretch_limit = limit;
    return parameters;
}

/// A sheet whose springs are stretched and compressed by up to two fifths, and every particle moves, but for the pins.
struct ShakenSheet {
    ClothModel model;
    ClothState state;

    explicit ShakenSheet(Pins::Kind pinned = Pins::Kind::None) {
        const ClothParameters parameters = limited_sheet({9, 7}, pinned);
        std::mt19937 random(3);
        model = make_cloth_model(parameters);
        state = test::random_state(parameters, random);
        const ClothState rest = make_rest_state(parameters);
        for (int p = 0; p < model.grid.particles(); ++p) {
            if (!model.pinned(p)) continue;
            state.x.row(p) = rest.x.row(p);
            state.v.row(p).setZero();
        }
    }

    [[nodiscard]] Real stretch() const { return largest_stretch(model, state.x); }
};

/// Two columns and rows; particle 1 is drawn away from particle 0 and moves away from it.
struct OneSpring {
    ClothModel model;
    ClothState state;

    explicit OneSpring(std::vector<int> pins) {
        ClothParameters parameters = limited_sheet({2, 2});
        parameters.height = 1;
        parameters.pinned = {Pins::Kind::List, std::move(pins)};
        model = make_cloth_model(parameters);
        state = make_rest_state(parameters);
        state.x(1, 0) = Real(1.5);
        state.v(1, 0) = 3;
    }
};

TEST(StretchLimit, DrawsAFreeEndToTheLimitAndStopsIt) {
    OneSpring spring({0, 2, 3});
    // As long as it was, whatever happens between 0 and 1
    spring.state.x.row(3) << 1 + limit, 0, Real(0.5);
    limit_stretch(spring.model, -1, spring.state);
    EXPECT_NEAR(spring.state.x(1, 0), 1 + limit, round_off);
    EXPECT_NEAR(spring.state.v(1, 0), 0, round_off);
    EXPECT_EQ(spring.state.x(0, 0), 0);
}

TEST(StretchLimit, SharesTheWayAmongTwoFreeEndsAndKeepsWhatDrawsThemTogether) {
    OneSpring spring({2, 3});
    spring.state.v(1, 0) = -3;
    limit_stretch(spring.model, -1, spring.state);
    EXPECT_NEAR(spring.state.x(0, 0), Real(0.2), Real(0.02)) << "of 0.4 together, one half each";
    EXPECT_LE(spring.state.x(1, 0) - spring.state.x(0, 0), 1 + limit + stretch_tolerance);
    EXPECT_EQ(spring.state.v(1, 0), -3);
}

TEST(StretchLimit, IsKeptWithinItsToleranceMovesNoPinAndTakesKineticEnergyOnly) {
    using enum Pins::Kind;
    for (const Pins::Kind pinned : {None, Two, Four, Row}) {
        ShakenSheet sheet(pinned);
        const ClothState before = sheet.state;
        ASSERT_GT(sheet.stretch(), limit + Real(0.1));
        EXPECT_NEAR(stretch_excess(sheet.model, sheet.state.x), sheet.stretch() - limit, round_off);
        const auto allocations = test::allocations();
        const StretchReport report = limit_stretch(sheet.model, -1, sheet.state);
        EXPECT_EQ(test::allocations(), allocations);
        EXPECT_LE(sheet.stretch(), limit + stretch_tolerance) << name_of(pinned);
        EXPECT_NEAR(report.excess, std::max(sheet.stretch() - limit, Real(0)), round_off);
        EXPECT_LT(report.sweeps, max_stretch_sweeps);
        EXPECT_LT(sheet.state.v.squaredNorm(), before.v.squaredNorm());
        for (int p = 0; p < sheet.model.grid.particles(); ++p) {
            if (!sheet.model.pinned(p)) continue;
            EXPECT_EQ(sheet.state.x.row(p), before.x.row(p));
            EXPECT_EQ(sheet.state.v.row(p), before.v.row(p));
        }
    }
}

TEST(StretchLimit, KeepsMomentumAndTheCentreOfMass) {
    ShakenSheet sheet;
    const ClothState before = sheet.state;
    limit_stretch(sheet.model, -1, sheet.state);
    EXPECT_GT((sheet.state.x - before.x).norm(), Real(0.02));
    EXPECT_GT((sheet.state.v - before.v).norm(), Real(0.1));
    EXPECT_LT((sheet.state.x - before.x).colwise().sum().norm(), round_off);
    EXPECT_LT((sheet.state.v - before.v).colwise().sum().norm(), round_off);
}

/// A state of rest that something has drawn out, or a limit that has just been set: nothing springs back.
TEST(StretchLimit, GivesAnOverstretchedClothAtRestNoSpeed) {
    ShakenSheet sheet(Pins::Kind::Two);
    sheet.state.v.setZero();
    limit_stretch(sheet.model, -1, sheet.state);
    EXPECT_TRUE(sheet.state.v.isZero(0));
}

TEST(StretchLimit, ReportsWhatPinsAskTooMuch) {
    ClothParameters parameters = limited_sheet({5, 2}, Pins::Kind::Two);
    const ClothModel model = make_cloth_model(parameters);
    ClothState state = make_rest_state(parameters);
    state.x.row(4) = 2 * state.x.row(4);
    const StretchReport report = limit_stretch(model, -1, state);
    EXPECT_EQ(report.sweeps, max_stretch_sweeps);
    EXPECT_NEAR(report.excess, 1 - limit, Real(0.4)) << "twice the length, shared by four springs in a row";
    EXPECT_EQ(report.excess, stretch_excess(model, state.x));
}

TEST(StretchLimit, LetsWhatIsHeldGiveWayToWhatIsPinned) {
    ClothParameters parameters = limited_sheet({5, 2}, Pins::Kind::Two);
    const ClothModel model = make_cloth_model(parameters);
    ClothState state = make_rest_state(parameters);
    state.x.row(4) = Real(1.3) * state.x.row(4);
    const StretchReport report = limit_stretch(model, 4, state);
    EXPECT_LE(report.excess, Real(0.02)) << "of 0.2, in one step";
    EXPECT_LT(state.x(4, 0), Real(1.13));
    EXPECT_EQ(state.x(0, 0), 0);
}

TEST(StretchLimit, ChangesNoBitOfWhatIsWithinIt) {
    ShakenSheet sheet;
    const ClothState before = sheet.state;
    for (const Real wide : {Real(0), sheet.stretch(), Real(10)}) {
        sheet.model.stretch_limit = wide;
        const StretchReport report = limit_stretch(sheet.model, -1, sheet.state);
        EXPECT_EQ(report.excess, 0);
        EXPECT_EQ(report.sweeps, 0);
        EXPECT_EQ(sheet.state.x, before.x);
        EXPECT_EQ(sheet.state.v, before.v);
    }
}

}  // namespace
}  // namespace drape
