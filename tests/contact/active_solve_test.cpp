// Sweeps that skip contacts with hardly anything to solve end near where sweeps over all contacts end.

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "contact/active_solve.h"
#include "drape/contact/fast_solve.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"

namespace drape {
namespace {

constexpr Real thickness = Real(2e-3);

/// What the response allows each contact to be off by, see `displacement_tolerance` [m].
constexpr Real tolerance = Real(1e-3) * thickness;

/// Sheets that have been pressed onto each other, and the lowest onto a ball that is free, where layers pass pushes on.
struct Layers {
    std::vector<ClothModel> models;
    std::vector<ClothState> states;
    std::vector<Points> before;
    std::vector<std::vector<Contact>> contacts;
    std::vector<PairContact> pairs;
    std::vector<Ball> balls{{.centre = Vec3(0, Real(-0.30199), 0),
                             .radius = Real(0.3),
                             .velocity = Vec3(0, Real(0.1), 0),
                             .inverse_mass = 200}};
    ResponseReport report;

    explicit Layers(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<Real> noise(-1, 1);
        constexpr int sheets = 3;
        for (int sheet = 0; sheet < sheets; ++sheet) {
            ClothParameters cloth;
            cloth.particles = {9 + sheet, 12 - sheet};
            cloth.width = cloth.height = Real(0.3);
            cloth.centred = true;
            cloth.place = {0, static_cast<Real>(sheet) * Real(0.98) * thickness, 0};
            models.push_back(make_cloth_model(cloth));
            states.push_back(make_rest_state(cloth));
            Points& x = states.back().x;
            x.col(1).array() += x.col(0).array() * x.col(2).array() * Real(0.2);
            before.push_back(x);
            for (Real& height : x.col(1)) height += Real(0.005) * thickness * noise(random);
            for (Real& speed : states.back().v.reshaped()) speed = Real(0.01) * noise(random);
        }
        contacts.resize(models.size());
        std::vector<CellRun> cells;
        list_all_cells(models[0].grid, cells);
        find_contacts(models[0].grid, states[0].x, balls[0], 0, thickness, cells, contacts[0], Kernels::Plain);
        for (int first = 0; first < sheets; ++first) {
            for (int second = first + 1; second < sheets; ++second) find_pairs(first, second);
        }
    }

    void find_pairs(int first, int second) {
        const auto boxed = [&](int number, CellBoxes& boxes, std::vector<Real>& reaches) {
            const auto c = static_cast<std::size_t>(number);
            reaches.assign(static_cast<std::size_t>(models[c].grid.particles()), thickness);
            boxes.build(models[c].grid, before[c], reaches);
            return BoxedCloth{{number, models[c].grid, before[c]}, boxes, reaches};
        };
        const auto all_of = [&](int number) {
            const Grid& grid = models[static_cast<std::size_t>(number)].grid;
            return CellRange{0, 0, grid.cell_columns(), grid.cell_rows()};
        };
        CellBoxes boxes, other_boxes;
        std::vector<Real> reaches, other_reaches;
        const LeafPair leaves{all_of(first), all_of(second)};
        std::vector<NearPair> near;
        find_near_pairs(boxed(first, boxes, reaches), boxed(second, other_boxes, other_reaches), {&leaves, 1}, near);
        for (const NearPair& pair : near) {
            if (!pair.stands_alone) continue;
            pairs.emplace_back().pair = pair;
            pairs.back().normal = pair.normal;
        }
    }

    void respond(Real friction, FastSolve* fast) {
        std::vector<ClothInContact> cloths;
        for (std::size_t c = 0; c < models.size(); ++c) {
            cloths.push_back({models[c], before[c], states[c], contacts[c]});
        }
        const ResponseParameters parameters{
            .friction = friction, .thickness = thickness, .pair_thickness = thickness, .pairs = true};
        report = resolve_contacts(parameters, Real(1e-3), cloths, pairs, balls, {}, fast);
    }

    /// The deepest that a pair is inside the thickness [m].
    [[nodiscard]] Real depth() const {
        Real deepest = 0;
        for (const PairContact& contact : pairs) deepest = std::max(deepest, contact.depth);
        return deepest;
    }
};

TEST(ActiveSolve, EndsWhereSweepsOverAllContactsEnd) {
    FastSolve fast;
    std::size_t pairs = 0;
    for (const Real friction : {Real(0), Real(0.4)}) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            Layers plain(seed), active = plain;
            plain.respond(friction, nullptr);
            active.respond(friction, &fast);
            ASSERT_FALSE(fast.activity.entries().empty()) << "solved by plain code";
            EXPECT_LE(plain.report.residual, tolerance) << "a reference that has converged";
            EXPECT_LE(active.report.residual, tolerance);
            EXPECT_NEAR(active.depth(), plain.depth(), 2 * tolerance);
            Real longest = 0;
            for (std::size_t c = 0; c < plain.states.size(); ++c) {
                const Real apart = (plain.states[c].x - active.states[c].x).cwiseAbs().maxCoeff();
                const Real moved = (plain.states[c].x - Layers(seed).states[c].x).cwiseAbs().maxCoeff();
                longest = std::max(longest, moved);
                EXPECT_LE(apart, 2 * tolerance) << "friction " << friction << ", seed " << seed << ", sheet " << c;
            }
            EXPECT_GT(longest, 15 * tolerance) << "pushes are much longer than that";
            EXPECT_NEAR((active.balls[0].velocity - plain.balls[0].velocity).norm(), 0, Real(1e-3));
            EXPECT_LT(active.balls[0].velocity.y(), Real(0.09)) << "the ball is pushed";
            pairs += plain.pairs.size();
        }
    }
    EXPECT_GT(pairs, 10'000u);
}

/// Contacts in a row, each at a particle of the next, of which the first two push each other for some sweeps.
TEST(ActiveSolve, LooksAtEveryContactLastOfAll) {
    const Layers layers(1);
    std::vector<ClothState> states = layers.states;
    std::vector<std::vector<Contact>> none(states.size());
    std::vector<ClothInContact> cloths;
    for (std::size_t c = 0; c < states.size(); ++c) {
        cloths.push_back({layers.models[c], layers.before[c], states[c], none[c]});
    }
    std::vector<PairContact> pairs(10);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        pairs[k].particle_count = 2;
        for (int of = 0; of < 2; ++of) {
            pairs[k].particles[static_cast<std::size_t>(of)] = {.particle = static_cast<int>(k) + of, .share = 1};
        }
    }
    for (const int sweeps_of_two : {1, 5, most_sweeps + 1}) {
        const ResponseParameters parameters;
        ContactProblem problem{.parameters = parameters,
                               .h = 1,
                               .share = 1,
                               .gravity = 0,
                               .resting = 0,
                               .cloths = cloths,
                               .pairs = pairs,
                               .balls = {},
                               .ball_contacts = {}};
        std::vector<std::size_t> visited;
        std::map<std::size_t, int> times;
        ContactActivity activity;
        const Sweeps sweeps = sweep_active(problem, activity, 1, [&](const auto& contact) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(contact)>, PairContact>) {
                const auto k = static_cast<std::size_t>(&contact - pairs.data());
                visited.push_back(k);
                return ++times[k] <= sweeps_of_two && k < 2 ? Real(4) : Real(0);
            }
            return Real(0);
        });
        const bool ends = sweeps_of_two < most_sweeps;
        EXPECT_EQ(sweeps.residual, ends ? 0 : 2);
        EXPECT_EQ(sweeps.count, ends ? sweeps_of_two + 2 : most_sweeps);
        ASSERT_GE(visited.size(), pairs.size());
        const std::span all_at_last = std::span(visited).last(pairs.size());
        for (std::size_t k = 0; k < pairs.size(); ++k) EXPECT_EQ(all_at_last[k], k);
        EXPECT_EQ(times[9], 2) << "in the first sweep and in the last one";
    }
}

TEST(ActiveSolve, SolvesAContactAgainWhenAnythingInItWasPushed) {
    const Layers layers(1);
    std::vector<ClothInContact> cloths;
    std::vector<ClothState> states = layers.states;
    std::vector<std::vector<Contact>> contacts = layers.contacts;
    for (std::size_t c = 0; c < states.size(); ++c) {
        cloths.push_back({layers.models[c], layers.before[c], states[c], contacts[c]});
    }
    const auto pair_of = [](std::array<int, 4> particles) {
        PairContact contact;
        for (const int particle : particles) {
            contact.particles[static_cast<std::size_t>(contact.particle_count++)] = {particle % 2, particle, 1, 1};
        }
        return contact;
    };
    const auto at = [](auto& activity, std::size_t k) -> ContactActivity::Entry& { return activity.entries()[k]; };
    for (int shared = 2; shared <= 5; ++shared) {
        ContactActivity activity;
        activity.begin(cloths, layers.balls);
        activity.add(pair_of({2, 3, 4, 5}));
        activity.add(pair_of({10, 11, 12, shared}));
        activity.add(pair_of({20, 21, 22, 23}));
        for (std::size_t k = 0; k < 3; ++k) activity.mark_solved(at(activity, k), false);
        activity.mark_solved(at(activity, 1), false);
        EXPECT_FALSE(activity.is_pending(at(activity, 0))) << "a push that can be neglected";
        activity.mark_solved(at(activity, 1), true);
        EXPECT_TRUE(activity.is_pending(at(activity, 0))) << "particle " << shared;
        EXPECT_FALSE(activity.is_pending(at(activity, 1))) << "it has just been solved";
        EXPECT_FALSE(activity.is_pending(at(activity, 2))) << "it shares no particle";
        activity.mark_solved(at(activity, 0), false);
        EXPECT_FALSE(activity.is_pending(at(activity, 0)));
    }
    // A free ball is pushed as particles are; one that is led, and the ground, are not
    const auto on_ball = [](int ball) {
        Contact contact;
        contact.ball = ball;
        return contact;
    };
    std::vector<Ball> balls = layers.balls;
    balls.push_back({.centre = Vec3(1, 0, 0)});
    ContactActivity activity;
    activity.begin(cloths, balls);
    for (const int ball : {0, 0, 1, 1, the_ground, the_ground}) activity.add(on_ball(ball));
    for (std::size_t k = 0; k < 6; k += 2) {
        activity.mark_solved(at(activity, k), true);
        EXPECT_EQ(activity.is_pending(at(activity, k + 1)), k == 0);
    }
    // Between two balls, either of which may be pushed by another contact
    balls.push_back({.centre = Vec3(0, 1, 0), .inverse_mass = 1});
    const auto between = [](int first, int second) {
        BallContact contact;
        contact.first = first;
        contact.ball = second;
        return contact;
    };
    for (const int other : {0, 2}) {
        activity.begin(cloths, balls);
        activity.add(between(0, 2));
        activity.add(between(other, 1));
        activity.mark_solved(at(activity, 0), false);
        activity.mark_solved(at(activity, 1), true);
        EXPECT_TRUE(activity.is_pending(at(activity, 0))) << "ball " << other;
    }
}

}  // namespace
}  // namespace drape
