// What two sides of a contact give each other is one impulse, within Coulomb's cone, in every response.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "drape/contact/detection.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"
#include "searched_cloth.h"

namespace drape {
namespace {

/// Two crumpled sheets that are cut by a ball, by the ground, and by each other.
struct TwoSheets {
    std::vector<ClothModel> models;
    std::vector<ClothState> states;
    std::vector<Points> before;
    std::vector<Body> bodies;
    std::vector<ContactRow> rows;

    TwoSheets(unsigned seed, const Ball& ball, const Surface& surface)
        : bodies{body_of(ball, surface), body_of(Ground{0, true, surface.friction, surface.restitution})} {
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> noise(-1, 1);
        const auto crumpled = [&](Points x, Real by) {
            for (Real& number : x.reshaped()) number += by * noise(random);
            return x;
        };
        for (const int side : {9, 12}) {
            ClothParameters cloth;
            cloth.particles = {side, side};
            cloth.width = cloth.height = 1;
            cloth.centred = true;
            cloth.place = {0, Real(0.02), 0};
            if (side == 9) cloth.pinned.kind = Pins::Kind::Two;
            models.push_back(make_cloth_model(cloth));
            states.push_back(make_rest_state(cloth));
            states.back().x = crumpled(states.back().x, Real(0.02));
            states.back().v = crumpled(states.back().v, Real(0.5));
            before.push_back(crumpled(states.back().x, Real(1e-3)));
        }
        for (int c = 0; c < 2; ++c) find_with_bodies(c, ball);
        find_pairs();
        for (ContactRow& row : rows) {
            row.displacement = {std::max(noise(random), Real(0)) * Real(1e-7),
                                Real(1e-7) * Vec3(noise(random), noise(random), noise(random))};
            row.impulse = {std::max(noise(random), Real(0)) * Real(1e-4), Vec3::Zero()};
        }
    }

    void respond(const ResponseParameters& parameters) {
        std::vector<ClothInContact> cloths;
        for (std::size_t c = 0; c < models.size(); ++c) cloths.push_back({models[c], before[c], states[c]});
        ContactSolver().resolve(parameters, Real(1e-3), cloths, bodies, rows);
    }

    [[nodiscard]] Vec3 momentum() const {
        Vec3 sum = bodies[0].inverse_mass > 0 ? Vec3(bodies[0].velocity / bodies[0].inverse_mass) : Vec3(0, 0, 0);
        for (std::size_t c = 0; c < models.size(); ++c) {
            sum += models[c].particle_mass * states[c].v.colwise().sum().transpose();
        }
        return sum;
    }

private:
    static constexpr Real thickness = Real(0.002);

    void find_with_bodies(int number, const Ball& ball) {
        const auto c = static_cast<std::size_t>(number);
        const std::vector<CellRange> cells{all_cells(models[c].grid)};
        const MovingCloth cloth{models[c].grid, states[c].x, states[c].x, number};
        find_contacts(cloth, ball, {0, thickness}, cells, rows, Kernels::Plain);
        find_ground_contacts(cloth, 0, {1, thickness}, cells, rows);
    }

    void find_pairs() {
        test::SearchedCloth first(0, models[0].grid, {}), second(1, models[1].grid, {});
        first.build(states[0].x);
        second.build(states[1].x);
        for (const NearPair& pair : test::pairs_within(first, second, 2 * thickness)) {
            if (pair.is_representative) rows.push_back(row_of(pair, thickness));
        }
    }
};

Ball turning_ball() {
    Ball ball{.centre = Vec3(0, Real(-0.25), 0), .radius = Real(0.3)};
    ball.moved = Vec3(Real(1e-3), Real(2e-3), 0);
    ball.velocity = ball.moved / Real(1e-3);
    ball.turned = Vec3(0, Real(1e-3), Real(2e-3));
    ball.spin = ball.turned / Real(1e-3);
    return ball;
}

/// The ground, which takes what it is given, is far below.
TEST(ContactSolver, KeepsTheMomentumOfClothsAndABallThatIsPushed) {
    for (const ResponseKind kind : values_of<ResponseKind>()) {
        Ball ball = turning_ball();
        ball.inverse_mass = 2;
        TwoSheets sheets(3, ball, {Real(0.4), Real(0.3)});
        sheets.models[0].inverse_mass.setConstant(1 / sheets.models[0].particle_mass);  // no pins
        std::erase_if(sheets.rows, [](const ContactRow& row) { return row.body == 1; });
        for (ContactRow& row : sheets.rows) row.impulse = row.displacement = {};
        const Vec3 before = sheets.momentum();
        sheets.respond({.kind = kind});
        EXPECT_NE(sheets.bodies[0].velocity, ball.velocity) << name_of(kind);
        const Real rounding = std::max(Real(1e-10), 100 * std::numeric_limits<Real>::epsilon());
        EXPECT_LT((sheets.momentum() - before).norm(), rounding * (1 + before.norm())) << name_of(kind);
    }
}

TEST(ContactSolver, PushesAndNeverPullsAndStaysInTheConeOfFriction) {
    for (const ResponseKind kind : values_of<ResponseKind>()) {
        TwoSheets sheets(4, turning_ball(), {Real(0.4), 0});
        sheets.respond({.kind = kind, .friction = Real(0.4)});
        for (const RowKind of : {RowKind::Particle, RowKind::Triangle, RowKind::Pair}) {
            EXPECT_GT(std::ranges::count_if(
                          sheets.rows, [of](const ContactRow& row) { return row.kind == of && row.has_impulse(); }),
                      3)
                << name_of(kind);
        }
        for (const ContactRow& row : sheets.rows) {
            for (const RowImpulse* given : {&row.displacement, &row.impulse}) {
                ASSERT_GE(given->normal, 0);
                ASSERT_LE(given->friction.norm(), Real(0.4) * given->normal * (1 + 1e-6) + 1e-7) << name_of(kind);
            }
        }
    }
}

}  // namespace
}  // namespace drape
