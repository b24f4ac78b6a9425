// Which pushes of what rests are given in the next substep.

#include "drape/contact/warm_start.h"

#include <gtest/gtest.h>

#include <vector>

namespace drape {
namespace {

constexpr Real substep = Real(5e-4), earth = Real(9.81);

/// A cell, and contacts of its first triangle.
struct RestingSheet {
    ClothModel model;
    ClothState state;
    Points before;
    ResponseParameters parameters;
    std::vector<Contact> contacts;
    WarmStart<Contact> warm_start;
    Ball ball;

    RestingSheet() {
        ClothParameters cloth;
        cloth.particles = {2, 2};
        model = make_cloth_model(cloth);
        state = make_rest_state(cloth);
        before = state.x;
    }

    ClothInContact in_contact() { return {model, before, state, contacts}; }
};

/// Of the first particle with a body above which it lies.
Contact contact_of_particle(const ClothModel& model, Real inverse_mass_of_body) {
    Contact contact;
    contact.corners = model.grid.triangle_corners(0);
    contact.barycentric = {1, 0, 0};
    contact.of_particle = true;
    contact.normal = {0, 1, 0};
    contact.inverse_mass = 1 / model.particle_mass + inverse_mass_of_body;
    contact.particle_count = 1;
    contact.particles[0] = {0, contact.corners[0], 1, 1 / model.particle_mass};
    return contact;
}

/// How much of a push is given on to the next substep, and to the one after it, of a particle that meets a body.
/// @param gravities the push, in what gravity gives the particle within a step
std::vector<Real> given_on(Real gravities, Real inverse_mass_of_body) {
    RestingSheet sheet;
    const ClothInContact cloth = sheet.in_contact();
    const Real push = gravities * sheet.model.particle_mass * earth * substep * substep;
    std::vector<Real> given;
    for (int k = 0; k < 3; ++k) {
        sheet.contacts = {contact_of_particle(sheet.model, inverse_mass_of_body)};
        sheet.warm_start.carry_over(sheet.parameters, std::span(&cloth, 1), std::span(&sheet.ball, 1), sheet.contacts);
        given.push_back(sheet.contacts[0].impulse.normal * substep / push);
        sheet.contacts[0].displacement.normal = push;
        sheet.contacts[0].impulse.normal = push / substep;
        sheet.warm_start.take(sheet.parameters, substep, earth, std::span(&cloth, 1), sheet.contacts);
    }
    return given;
}

TEST(RestingPush, IsGivenOn) {
    EXPECT_EQ(given_on(10, 0), (std::vector<Real>{0, 1, 1}));
    EXPECT_EQ(given_on(10, Real(0.1)), (std::vector<Real>{0, 1, 1}));
}

TEST(RestingPush, IsNoneWhereALightClothIsHitByWhatDoesNotMove) {
    EXPECT_EQ(given_on(200, 0), (std::vector<Real>{0, 0, 0}));
}

TEST(RestingPush, IsGivenWithTheShareOfItsImpulseThatAForceDisplacesBy) {
    for (const Real share : {Real(0.5), Real(1)}) {
        RestingSheet sheet;
        const ClothInContact cloth = sheet.in_contact();
        sheet.parameters.displacement_share = share;
        sheet.contacts = {contact_of_particle(sheet.model, 0)};
        const Real impulse = earth * substep * sheet.model.particle_mass;
        sheet.contacts[0].displacement.normal = share * substep * impulse;
        sheet.contacts[0].impulse.normal = impulse;
        sheet.warm_start.take(sheet.parameters, substep, earth, std::span(&cloth, 1), sheet.contacts);
        sheet.warm_start.give(std::span(&cloth, 1), std::span(&sheet.ball, 1));
        const int particle = sheet.model.grid.triangle_corners(0)[0];
        EXPECT_NEAR(sheet.state.v(particle, 1) / (earth * substep), share, 1e-6);
        EXPECT_NEAR((sheet.state.x - sheet.before)(particle, 1) / (share * earth * substep * substep), 1, 1e-4);
        EXPECT_EQ(sheet.state.v.sum(), sheet.state.v(particle, 1)) << "and no other";
    }
}

TEST(RestingPush, IsDroppedWhenTheGroundIsRemovedOrLowered) {
    RestingSheet sheet;
    const ClothInContact cloth = sheet.in_contact();
    const auto pushes_after = [&](const Ground& ground) {
        sheet.contacts = {contact_of_particle(sheet.model, 0)};
        sheet.contacts[0].displacement.normal = sheet.model.particle_mass * earth * substep * substep;
        sheet.contacts[0].ball = the_ground;
        sheet.parameters.ground = ground;
        sheet.warm_start.take(sheet.parameters, substep, earth, std::span(&cloth, 1), sheet.contacts);
        return sheet.warm_start.pushes().size();
    };
    EXPECT_EQ(pushes_after({.height = 0}), 1u);
    EXPECT_EQ(pushes_after({.height = Real(0.1)}), 1u);
    EXPECT_EQ(pushes_after({.height = Real(0.05)}), 0u);
    EXPECT_EQ(pushes_after({.height = Real(0.05), .solid = false}), 0u);
}

/// As a ball is carried that is heavier than the particles under it; that it lies there is seen in the second substep.
TEST(RestingPush, MayBeThatOfAHeavyBallIfItLasts) {
    EXPECT_EQ(given_on(200, Real(0.1)), (std::vector<Real>{0, 0, 1})) << "its weight";
    EXPECT_EQ(given_on(500, Real(0.1)), (std::vector<Real>{0, 0, 1})) << "2.5 times its weight";
    EXPECT_EQ(given_on(700, Real(0.1)), (std::vector<Real>{0, 0, 0})) << "3.5 times, an impact of the ball";
}

}  // namespace
}  // namespace drape
