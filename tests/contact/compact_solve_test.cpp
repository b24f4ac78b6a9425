// Sweeps over compact rows have the bits of plain ones: of positions, velocities, pushes and what is reported.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "drape/contact/contact_rows.h"
#include "drape/contact/response.h"

namespace drape {
namespace {

/// Contacts of two sheets with bodies, as the response leaves them.
struct TwoSheets {
    std::vector<ClothModel> models;
    std::vector<ClothState> states;
    std::vector<Points> before;
    std::vector<std::vector<Contact>> contacts;
    std::vector<Ball> balls;
    ResponseReport report;

    /// Two sheets that are crumpled, and cut by a ball and by the ground.
    explicit TwoSheets(unsigned seed, const Ball& ball, const ResponseParameters& parameters) : balls{ball} {
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> noise(-1, 1);
        const auto crumpled = [&](const Points& x, Real by) {
            Points result = x;
            for (Real& number : result.reshaped()) number += by * noise(random);
            return result;
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
            std::vector<CellRun> cells;
            const Grid& grid = models.back().grid;
            list_all_cells(grid, cells);
            std::vector<Contact>& found = contacts.emplace_back();
            const Points& x = states.back().x;
            find_contacts(grid, {x, x}, ball, 0, parameters.thickness, 0, cells, found, Kernels::Plain);
            find_ground_contacts(grid, x, parameters.ground.height, parameters.thickness, found);
            for (Contact& contact : found) {
                contact.displacement = {.normal = std::max(noise(random), Real(0)) * Real(1e-7)};
                contact.impulse = {.normal = std::max(noise(random), Real(0)) * Real(1e-4)};
                contact.displacement.friction = Real(1e-7) * Vec3(noise(random), noise(random), noise(random));
            }
        }
    }

    void respond(const ResponseParameters& parameters, ContactRows* rows) {
        std::vector<ClothInContact> cloths;
        for (std::size_t c = 0; c < models.size(); ++c) {
            cloths.push_back({models[c], before[c], states[c], contacts[c]});
        }
        report = resolve_contacts(parameters, Real(1e-3), cloths, {}, balls, {}, rows);
    }
};

bool same_push(const ContactPush& a, const ContactPush& b) { return a.normal == b.normal && a.friction == b.friction; }

bool same_result(const TwoSheets& a, const TwoSheets& b) {
    for (std::size_t c = 0; c < a.states.size(); ++c) {
        if (a.states[c].x != b.states[c].x || a.states[c].v != b.states[c].v) return false;
        const bool same =
            std::ranges::equal(a.contacts[c], b.contacts[c], [](const Contact& one, const Contact& other) {
                return same_push(one.displacement, other.displacement) && same_push(one.impulse, other.impulse) &&
                       one.depth == other.depth;
            });
        if (!same) return false;
    }
    return a.report.depth == b.report.depth && a.report.residual == b.report.residual &&
           a.report.sweeps == b.report.sweeps;
}

TEST(CompactSolve, HasTheBitsOfThePlainOne) {
    ContactRows rows;
    const Ball still{.centre = Vec3(0, Real(-0.25), 0), .radius = Real(0.3)};
    Ball turning = still;
    turning.moved = Vec3(Real(1e-3), Real(2e-3), 0);
    turning.velocity = turning.moved / Real(1e-3);
    turning.turned = Vec3(0, Real(1e-3), Real(2e-3));
    turning.spin = turning.turned / Real(1e-3);
    std::size_t contacts = 0;
    int sweeps = 0;
    for (const Ball& ball : {still, turning}) {
        for (const Real friction : {Real(0), Real(0.4)}) {
            for (const Real restitution : {Real(0), Real(0.6)}) {
                const ResponseParameters parameters{
                    .friction = friction, .restitution = restitution, .ground = {.height = 0, .friction = friction}};
                for (unsigned seed = 1; seed <= 20; ++seed) {
                    TwoSheets plain(seed, ball, parameters), compact = plain;
                    plain.respond(parameters, nullptr);
                    rows.clear();
                    compact.respond(parameters, &rows);
                    EXPECT_FALSE(rows.contacts.empty()) << "solved by plain code";
                    EXPECT_TRUE(same_result(plain, compact))
                        << "friction " << friction << ", restitution " << restitution << ", seed " << seed;
                    contacts += plain.contacts[0].size() + plain.contacts[1].size();
                    sweeps += plain.report.sweeps;
                }
            }
        }
    }
    EXPECT_GT(contacts, 4'000u);
    EXPECT_GT(sweeps, 1'000);
}

TEST(CompactSolve, IsLeftToThePlainOneWhereContactsPushABall) {
    ContactRows rows;
    const ResponseParameters parameters{.ground = {.height = 0}};
    const Ball free{.centre = Vec3(0, Real(-0.25), 0), .radius = Real(0.3), .inverse_mass = 2};
    TwoSheets plain(1, free, parameters), compact = plain;
    plain.respond(parameters, nullptr);
    compact.respond(parameters, &rows);
    EXPECT_TRUE(rows.contacts.empty());
    EXPECT_TRUE(same_result(plain, compact));
    EXPECT_NE(compact.balls[0].velocity, free.velocity) << "it was pushed";
    EXPECT_EQ(compact.balls[0].velocity, plain.balls[0].velocity);
}

}  // namespace
}  // namespace drape
