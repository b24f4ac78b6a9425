// Where the pushes of what rests are given in the next substep, and which are.

#include "drape/contact/warm_start.h"

#include <gtest/gtest.h>

#include <array>
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
        contacts[0].impulse.normal = contacts[0].displacement.normal / substep;
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

/// Under the implicit midpoint rule, whose pushes are impulses.
struct MidpointContact : RollingContact {
    ClothInContact cloth = in_contact();
    std::array<Ball, 2> balls;
    Real impulse = model.particle_mass * earth * substep;  ///< what gravity gives within a substep

    MidpointContact() : RollingContact(IntegratorKind::ImplicitMidpoint) {}

    void take() { warm_start.take(parameters, substep, earth, std::span(&cloth, 1), contacts); }
    void carry_over() { warm_start.carry_over(parameters, std::span(&cloth, 1), balls, contacts); }

    /// A contact that has pushed with so many times what gravity gives, and displaced by some of that.
    void push(Real gravities) {
        contacts = {contact_of_particle(model, 0)};
        contacts[0].displacement.normal = gravities * impulse * substep / 5;
        contacts[0].impulse.normal = gravities * impulse;
    }

    [[nodiscard]] Real given_on() const { return warm_start.pushes()[0].impulse.normal / impulse; }
};

/// It holds the particle against gravity, and nothing is given before the step or after it.
TEST(RestingPush, IsAForceOfTheStepUnderTheImplicitMidpointRule) {
    MidpointContact sheet;
    sheet.push(1);
    sheet.take();
    const Real* const force = sheet.warm_start.within_step(sheet.model);
    ASSERT_NE(force, nullptr);
    const int particle = sheet.model.grid.triangle_corners(0)[0];
    const Eigen::Map<const Points> forces(force, sheet.state.x.rows(), 3);
    EXPECT_NEAR(forces(particle, 1) / (sheet.model.particle_mass * earth), 1, 1e-6);
    EXPECT_EQ(forces.sum(), forces(particle, 1)) << "on no other";
    sheet.warm_start.before_step(std::span(&sheet.cloth, 1), sheet.balls);
    sheet.warm_start.after_step(std::span(&sheet.cloth, 1), sheet.balls);
    EXPECT_TRUE(sheet.state.v.isZero(0));

    sheet.contacts = {contact_of_particle(sheet.model, 0)};
    sheet.carry_over();
    EXPECT_EQ(sheet.contacts[0].displacement.normal, 0) << "what the step displaced by is not taken back";
    EXPECT_NEAR(sheet.contacts[0].impulse.normal / sheet.impulse, 1, 1e-6);
}

TEST(RestingPush, IsAForceOfTheStepUnlessAMethodTakesItsForcesFromTheStartAloneOrIsBdf2) {
    for (const std::string_view name : names_of<IntegratorKind>()) {
        const IntegratorKind integrator = value_named<IntegratorKind>(name).value();
        RollingContact sheet(integrator);
        const ClothInContact cloth = sheet.in_contact();
        sheet.contacts = {contact_of_particle(sheet.model, 0)};
        sheet.contacts[0].displacement.normal = sheet.contacts[0].impulse.normal = Real(1e-9);
        sheet.warm_start.take(sheet.parameters, substep, earth, std::span(&cloth, 1), sheet.contacts);
        const bool takes_none = integrator == IntegratorKind::ExplicitEuler ||
                                integrator == IntegratorKind::SymplecticEuler || integrator == IntegratorKind::Bdf2;
        EXPECT_EQ(sheet.warm_start.within_step(sheet.model) == nullptr, takes_none) << name;
    }
}

TEST(RestingPush, IsTakenBackWhereAContactPartedUnderTheImplicitMidpointRule) {
    MidpointContact sheet;
    sheet.push(1);
    sheet.take();
    sheet.contacts.clear();
    sheet.carry_over();
    ASSERT_EQ(sheet.contacts.size(), 1u);
    EXPECT_NEAR(sheet.contacts[0].displacement.normal / (sheet.impulse * substep), 0.5, 1e-6) << "all that it gave";
    EXPECT_NEAR(sheet.contacts[0].impulse.normal / sheet.impulse, 1, 1e-6);
}

TEST(RestingPush, IsNoneOfAnImpactUnderTheImplicitMidpointRule) {
    MidpointContact sheet;
    sheet.push(90);
    sheet.take();
    EXPECT_NEAR(sheet.given_on(), 90, 1e-4);
    sheet.push(150);
    sheet.take();
    EXPECT_TRUE(sheet.warm_start.pushes().empty());
}

TEST(RestingPush, IsDroppedWhenTheGroundIsRemovedOrLowered) {
    MidpointContact sheet;
    const auto pushes_after = [&](const Ground& ground) {
        sheet.push(1);
        sheet.contacts[0].ball = the_ground;
        sheet.parameters.ground = ground;
        sheet.take();
        return sheet.warm_start.pushes().size();
    };
    EXPECT_EQ(pushes_after({.height = 0}), 1u);
    EXPECT_EQ(pushes_after({.height = Real(0.1)}), 1u);
    EXPECT_EQ(pushes_after({.height = Real(0.05)}), 0u);
    EXPECT_EQ(pushes_after({.height = Real(0.05), .solid = false}), 0u);
}

/// As a displacement: half of the impulse, all of it before the step.
TEST(RestingPush, GoesOnWhereAFreeBallComesToTouchUnderTheImplicitMidpointRule) {
    MidpointContact sheet;
    sheet.push(1);
    sheet.take();
    sheet.contacts = {contact_of_particle(sheet.model, 0), contact_of_particle(sheet.model, 1)};
    sheet.contacts[1].ball = 1;
    sheet.balls[1].inverse_mass = 1;
    sheet.carry_over();
    sheet.take();
    ASSERT_FALSE(sheet.warm_start.pushes().empty());
    EXPECT_NEAR(sheet.given_on(), 0.5, 1e-6);
}

/// As a ball is carried that is heavier than the particles under it; that it lies there is seen in the second substep.
TEST(RestingPush, MayBeThatOfAHeavyBallIfItLasts) {
    EXPECT_EQ(given_on(200, Real(0.1)), (std::vector<Real>{0, 0, 1})) << "its weight";
    EXPECT_EQ(given_on(500, Real(0.1)), (std::vector<Real>{0, 0, 1})) << "2.5 times its weight";
    EXPECT_EQ(given_on(700, Real(0.1)), (std::vector<Real>{0, 0, 0})) << "3.5 times, an impact of the ball";
}

}  // namespace
}  // namespace drape
