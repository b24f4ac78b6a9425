#include "drape/contact/warm_start.h"

#include <gtest/gtest.h>

namespace drape {
namespace {

constexpr Real step = Real(5e-4), gravity = Real(9.81);

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
        contacts[0].displacement.normal = model.particle_mass * gravity * step * step;
        warm_start.take(parameters, step, gravity, std::span(&cloth, 1), contacts);
    }

    [[nodiscard]] Real pushed_at() const { return warm_start.pushes()[0].barycentric[1]; }
};

TEST(WarmStart, PushesAheadOfAContactThatRolls) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    rolling.find_at(Real(0.3));
    EXPECT_EQ(rolling.pushed_at(), Real(0.3));
    rolling.find_at(Real(0.34));
    EXPECT_NEAR(rolling.pushed_at(), 0.34 + 3 * 0.02, 1e-6);
    rolling.find_at(Real(0.38));
    EXPECT_NEAR(rolling.pushed_at(), 0.38 + 3 * 0.03, 1e-6);
}

TEST(WarmStart, DoesNotGoBackAndForthWithAContactThatDoes) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    for (const double part : {0.5, 0.52, 0.5, 0.52, 0.5, 0.52}) rolling.find_at(static_cast<Real>(part));
    EXPECT_NEAR(rolling.pushed_at(), 0.52, 0.021);
}

TEST(WarmStart, StaysInTheTriangleOfItsContact) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    rolling.find_at(Real(0.5));
    rolling.find_at(Real(0.9));
    EXPECT_NEAR(rolling.pushed_at(), 1, 1e-6);
}

TEST(WarmStart, PushesWhereTheContactOfAFreeBallIs) {
    RollingContact rolling(IntegratorKind::BackwardEuler);
    rolling.ball.inverse_mass = 1;
    for (const double part : {0.3, 0.34, 0.38}) rolling.find_at(static_cast<Real>(part));
    EXPECT_EQ(rolling.pushed_at(), Real(0.38));
}

TEST(WarmStart, PushesWhereTheContactIsUnderAnExplicitMethod) {
    RollingContact rolling(IntegratorKind::SymplecticEuler);
    for (const double part : {0.3, 0.34, 0.38}) rolling.find_at(static_cast<Real>(part));
    EXPECT_EQ(rolling.pushed_at(), Real(0.38));
}

}  // namespace
}  // namespace drape
