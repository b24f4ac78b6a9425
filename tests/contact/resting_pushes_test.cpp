// Where the pushes of what rests are given in the next substep, and which are.

#include "drape/contact/warm_start.h"

#include <gtest/gtest.h>

#include <vector>

namespace drape {
namespace {

constexpr Real substep = Real(5e-4), earth = Real(9.81);

/// A cell, and a contact of its first triangle that rolls along an edge.
struct RollingContact {
    ClothModel model;
    ClothState state;
    Points before;
    ResponseParameters parameters;
    std::vector<Contact> contacts;
    WarmStart<Contact> warm_start;
    Ball ball;

    explicit RollingContact(IntegratorKind integrator) {
        ClothParameters cloth;
        cloth.particles = {2, 2};
        model = make_cloth_model(cloth);
        state = make_rest_state(cloth);
        before = state.x;
        parameters.integrator = integrator;
    }

    ClothInContact in_contact() { return {model, before, state, contacts}; }

    /// A substep that finds the contact at this part of the edge from its first corner to its second.
    void find_at(Real part) {
        const ClothInContact cloth = in_contact();
        Contact contact;
        contact.corners = model.grid.triangle_corners(0);
        contact.barycentric = {1 - part, part, 0};
        contact.normal = {0, 1, 0};
        contact.inverse_mass = 1 / model.particle_mass;
        contacts = {contact};
        warm_start.carry_over(parameters, std::span(&cloth, 1), std::span(&ball, 1), contacts);
        contacts[0].displacement.normal = model.particle_mass * earth * substep * substep;
        warm_start.take(parameters, substep, earth, std::span(&cloth, 1), contacts);
    }

    [[nodiscard]] Real pushed_at() const { return warm_start.pushes()[0].barycentric[1]; }
};

TEST(RestingPush, PushesAheadOfAContactThatRolls) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    rolling.find_at(Real(0.3));
    EXPECT_EQ(rolling.pushed_at(), Real(0.3));
    rolling.find_at(Real(0.34));
    EXPECT_NEAR(rolling.pushed_at(), 0.34 + 3 * 0.02, 1e-6);
    rolling.find_at(Real(0.38));
    EXPECT_NEAR(rolling.pushed_at(), 0.38 + 3 * 0.03, 1e-6);
}

TEST(RestingPush, DoesNotGoBackAndForthWithAContactThatDoes) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    for (const double part : {0.5, 0.52, 0.5, 0.52, 0.5, 0.52}) rolling.find_at(static_cast<Real>(part));
    EXPECT_NEAR(rolling.pushed_at(), 0.52, 0.021);
}

TEST(RestingPush, StaysInTheTriangleOfItsContact) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    rolling.find_at(Real(0.5));
    rolling.find_at(Real(0.9));
    EXPECT_NEAR(rolling.pushed_at(), 1, 1e-6);
}

TEST(RestingPush, PushesWhereTheContactOfAFreeBallIs) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    rolling.ball.inverse_mass = 1;
    for (const double part : {0.3, 0.34, 0.38}) rolling.find_at(static_cast<Real>(part));
    EXPECT_EQ(rolling.pushed_at(), Real(0.38));
}

TEST(RestingPush, PushesWhereTheContactIsUnderAnExplicitMethod) {
    RollingContact rolling(IntegratorKind::SymplecticEuler);
    for (const double part : {0.3, 0.34, 0.38}) rolling.find_at(static_cast<Real>(part));
    EXPECT_EQ(rolling.pushed_at(), Real(0.38));
}

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
    RollingContact sheet(IntegratorKind::BackwardEuler);
    const ClothInContact cloth = sheet.in_contact();
    const Real push = gravities * sheet.model.particle_mass * earth * substep * substep;
    std::vector<Real> given;
    for (int k = 0; k < 3; ++k) {
        sheet.contacts = {contact_of_particle(sheet.model, inverse_mass_of_body)};
        sheet.warm_start.carry_over(sheet.parameters, std::span(&cloth, 1), std::span(&sheet.ball, 1), sheet.contacts);
        given.push_back(sheet.contacts[0].displacement.normal / push);
        sheet.contacts[0].displacement.normal = push;
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

/// Half of it before the step, which displaces the particle by all that its impulse can, and half of it after.
TEST(RestingPush, IsAnImpulseInTwoHalvesUnderTheImplicitMidpointRule) {
    RollingContact sheet(IntegratorKind::ImplicitMidpoint);
    const ClothInContact cloth = sheet.in_contact();
    const auto cloths = std::span(&cloth, 1);
    const auto balls = std::span(&sheet.ball, 1);
    const Real impulse = sheet.model.particle_mass * earth * substep;
    sheet.contacts = {contact_of_particle(sheet.model, 0)};
    sheet.contacts[0].displacement.normal = impulse * substep / 5;
    sheet.contacts[0].impulse.normal = impulse;
    sheet.warm_start.take(sheet.parameters, substep, earth, cloths, sheet.contacts);
    const auto upward = [&] { return sheet.state.v(sheet.model.grid.triangle_corners(0)[0], 1); };
    sheet.warm_start.before_step(cloths, balls);
    EXPECT_NEAR(upward() / (earth * substep), 0.5, 1e-6);
    sheet.warm_start.after_step(cloths, balls);
    EXPECT_NEAR(upward() / (earth * substep), 1, 1e-6);

    sheet.contacts = {contact_of_particle(sheet.model, 0)};
    sheet.warm_start.carry_over(sheet.parameters, cloths, balls, sheet.contacts);
    EXPECT_EQ(sheet.contacts[0].displacement.normal, 0) << "what the step displaced by is not taken back";
    EXPECT_NEAR(sheet.contacts[0].impulse.normal / impulse, 1, 1e-6);
}

/// As a ball is carried that is heavier than the particles under it; that it lies there is seen in the second substep.
TEST(RestingPush, MayBeThatOfAHeavyBallIfItLasts) {
    EXPECT_EQ(given_on(200, Real(0.1)), (std::vector<Real>{0, 0, 1}));
    EXPECT_EQ(given_on(Real(1e6), Real(0.1)), (std::vector<Real>{0, 0, 0})) << "an impact of a ball, too";
}

}  // namespace
}  // namespace drape
