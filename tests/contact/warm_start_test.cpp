// What a response goes on from: which impulses of before, of which contacts, and in which order.

#include "drape/contact/warm_start.h"

#include <gtest/gtest.h>

#include <vector>

namespace drape {
namespace {

constexpr Real substep = Real(5e-4), earth = Real(9.81);

/// A small cloth, above a body that may be pushed.
struct WarmSheet {
    ClothModel model = make_cloth_model(parameters());
    ClothState state = make_rest_state(parameters());
    Points before = state.x;
    std::vector<ContactRow> rows;
    ResponseParameters response;
    WarmStart warm_start;
    std::vector<Body> bodies = {body_of(Ball{}, {})};

    static ClothParameters parameters() {
        ClothParameters cloth;
        cloth.particles = {4, 4};
        return cloth;
    }

    [[nodiscard]] ClothInContact in_contact() { return {model, before, state}; }

    void take() {
        const ClothInContact cloth = in_contact();
        warm_start.take(response, substep, earth, std::span(&cloth, 1), bodies, rows);
    }
    void carry_over() {
        const ClothInContact cloth = in_contact();
        warm_start.carry_over(std::span(&cloth, 1), bodies, rows);
    }

    /// A contact of the first particle, or of the inside of a triangle.
    [[nodiscard]] static ContactRow contact(int triangle, bool of_particle) {
        ContactRow row;
        row.kind = of_particle ? RowKind::Particle : RowKind::Triangle;
        row.count = row.first_count = of_particle ? 1 : 3;
        const auto corners = Grid{4, 4}.triangle_corners(triangle);
        for (std::size_t k = 0; k < row.count; ++k) row.particles[k] = {0, corners[k], Real(1) / row.count};
        row.triangle = triangle;
        row.body = 0;
        row.normal = Vec3(0, 1, 0);
        return row;
    }

    void touch(const std::vector<int>& triangles, Real push) {
        rows.clear();
        for (const int triangle : triangles) {
            rows.push_back(contact(triangle, false));
            rows.back().displacement.normal = push;
        }
    }
};

/// The triangles of the contacts, negative where they were given nothing.
std::vector<int> told(const std::vector<int>& before, const std::vector<int>& found) {
    WarmSheet sheet;
    sheet.touch(before, Real(1e-9));
    sheet.take();
    EXPECT_TRUE(sheet.rows.empty());
    sheet.touch(found, 0);
    sheet.carry_over();
    std::vector<int> triangles;
    for (const ContactRow& row : sheet.rows) {
        triangles.push_back(row.displacement.normal > 0 ? row.triangle : -row.triangle);
    }
    return triangles;
}

using Triangles = std::vector<int>;

TEST(WarmStart, TellsContactsThatAreFoundAgainAndInsertsThoseThatHavePartedInTheirOrder) {
    EXPECT_EQ(told({3, 6}, {3, 6}), (Triangles{3, 6}));
    EXPECT_EQ(told({1, 3, 4, 6, 9}, {2, 3, 6, 7}), (Triangles{1, -2, 3, 4, 6, -7, 9}));
    EXPECT_EQ(told({1, 2, 8, 9}, {4, 5}), (Triangles{1, 2, -4, -5, 8, 9}));
    EXPECT_EQ(told({5, 6, 7}, {}), (Triangles{5, 6, 7}));
    EXPECT_EQ(told({}, {4, 7}), (Triangles{-4, -7}));
}

/// How much of an impulse is given on to the next substep, and to the one after it, of a particle that meets a body.
/// @param gravities the impulse, in what gravity gives the particle within a step
std::vector<Real> given_on(Real gravities, Real inverse_mass_of_body) {
    WarmSheet sheet;
    sheet.bodies[0].inverse_mass = inverse_mass_of_body;
    const Real push = gravities * sheet.model.particle_mass * earth * substep * substep;
    std::vector<Real> given;
    for (int k = 0; k < 3; ++k) {
        sheet.rows = {WarmSheet::contact(0, true)};
        sheet.carry_over();
        given.push_back(sheet.rows[0].impulse.normal * substep / push);
        sheet.rows[0].displacement.normal = push;
        sheet.rows[0].impulse.normal = push / substep;
        sheet.take();
    }
    return given;
}

TEST(WarmStart, GivesOnWhatRests) {
    EXPECT_EQ(given_on(10, 0), (std::vector<Real>{0, 1, 1}));
    EXPECT_EQ(given_on(10, Real(0.1)), (std::vector<Real>{0, 1, 1}));
}

TEST(WarmStart, GivesNothingWhereALightClothIsHitByWhatDoesNotMove) {
    EXPECT_EQ(given_on(200, 0), (std::vector<Real>{0, 0, 0}));
}

/// As a ball is carried that is heavier than the particles under it; that it lies there is seen in the second substep.
TEST(WarmStart, GivesOnTheWeightOfAHeavyBallIfItLasts) {
    WarmSheet sheet;
    const Real ball = sheet.model.particle_mass * 20;  // kg
    EXPECT_EQ(given_on(20, 1 / ball), (std::vector<Real>{0, 1, 1}));
    EXPECT_EQ(given_on(50, 1 / ball)[2], 1) << "2.5 times its weight";
    EXPECT_EQ(given_on(2000, 1 / ball), (std::vector<Real>{0, 0, 0})) << "an impact of the ball";
}

TEST(WarmStart, GivesTheShareOfAnImpulseThatAForceDisplacesBy) {
    for (const Real share : {Real(0.5), Real(1)}) {
        WarmSheet sheet;
        sheet.response.displacement_factor = share;
        sheet.rows = {WarmSheet::contact(0, true)};
        const Real impulse = earth * substep * sheet.model.particle_mass;
        sheet.rows[0].displacement.normal = share * substep * impulse;
        sheet.rows[0].impulse.normal = impulse;
        sheet.take();
        const ClothInContact cloth = sheet.in_contact();
        sheet.warm_start.give(std::span(&cloth, 1), sheet.bodies);
        const int particle = sheet.model.grid.triangle_corners(0)[0];
        EXPECT_NEAR(sheet.state.v(particle, 1) / (earth * substep), share, 1e-6);
        EXPECT_NEAR((sheet.state.x - sheet.before)(particle, 1) / (share * earth * substep * substep), 1, 1e-4);
        EXPECT_EQ(sheet.state.v.sum(), sheet.state.v(particle, 1)) << "and no other";
    }
}

}  // namespace
}  // namespace drape
