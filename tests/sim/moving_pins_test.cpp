// Pins that a scene moves: where they are, what they do to the cloth, its energy and its sleep, and bad input; and pins
// that the user sets and takes out in mid-run.

#include <gmock/gmock.h>

#include "drape/integrate/stability.h"
#include "sim/small_scene.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::HasSubstr;

constexpr double whole_turn = 0.8;  // s

/// `small_settings` without its ball, hung by row 0, which is shifted by (0.1, 0.2, 0) m and turned by a quarter about
/// the vertical until 0.8 s.
Settings turned_row() {
    Settings settings = small_settings();
    settings.balls.clear();
    settings.cloths[0].plane = Plane::XY;
    settings.cloths[0].pinned.kind = Pins::Kind::Row;
    PinSettings& pins = settings.pins.emplace_back();
    pins.particles = {0, 9};
    const Real end = static_cast<Real>(whole_turn);
    pins.shift = {{0, {0, 0, 0}}, {end, {Real(0.1), Real(0.2), 0}}};
    pins.turns = {{0, {0, 0, 0}}, {end, {0, Real(0.25), 0}}};
    return settings;
}

Simulation turned_row_under(IntegratorKind integrator, double dt) {
    Settings settings = turned_row();
    settings.solver.integrator = integrator;
    settings.solver.dt = dt;
    return {"pins", std::move(settings)};
}

const Points& positions_in(const Simulation& simulation) { return simulation.cloths()[0].state.x; }

/// The largest distance of a pin from where its row is to be once it has turned.
Real off_by_the_end(const Simulation& simulation) {
    const Vec3 middle(0, Real(0.6), 0), shift(Real(0.1), Real(0.2), 0);
    Real off = 0;
    for (int p = 0; p < 10; ++p) {
        const Real arm = static_cast<Real>(p) / 9 - Real(0.5);
        off = std::max(off, (position_of(simulation, p) - middle - shift - Vec3(0, 0, -arm)).norm());
    }
    return off;
}

class MovingPinsUnder : public testing::TestWithParam<IntegratorKind> {};

INSTANTIATE_TEST_SUITE_P(OneMethod, MovingPinsUnder, testing::Values(IntegratorKind::SymplecticEuler), name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, MovingPinsUnder, testing::ValuesIn(methods_but({IntegratorKind::ExplicitEuler})),
                         name_of_param);

TEST_P(MovingPinsUnder, EndWhereTheirPathsDo) {
    Simulation simulation = turned_row_under(GetParam(), has_step_limit(GetParam()) ? 1.0 / 1024 : 1.0 / 60);
    run_until(simulation, whole_turn + 0.1);
    EXPECT_LT(off_by_the_end(simulation), 1e-6);
    EXPECT_TRUE(simulation.cloths()[0].state.v.topRows(10).isZero(0));
    EXPECT_TRUE(only_few_rounds(simulation.run_warning())) << simulation.run_warning();
}

/// The particles hang on pins whose motion every method is to see alike.
TEST_P(MovingPinsUnder, LeadTheClothAsEveryMethodHasIt) {
    Simulation simulation = turned_row_under(GetParam(), 1.0 / 8192);
    Simulation reference = turned_row_under(IntegratorKind::Rk4, 1.0 / 4096);
    run_until(simulation, 0.5);
    run_until(reference, 0.5);
    EXPECT_LT((positions_in(simulation) - positions_in(reference)).rowwise().norm().maxCoeff(), 2e-3);
}

TEST(MovingPins, HaveTheirWorkInTheBalanceWhichCloses) {
    Settings settings = turned_row();
    settings.solver.integrator = IntegratorKind::VelocityVerlet;
    settings.solver.dt = 1.0 / 8192;
    settings.solver.ledger = true;
    Simulation simulation("pins", std::move(settings));
    const auto row = [&](const char* name) {
        static_cast<void>(simulation.view());
        return figure(simulation.report(), name);
    };
    const double start = row("energy");
    run_until(simulation, whole_turn + 0.1);
    EXPECT_GT(row("pin_work"), 0.15) << "the cloth is lifted by 0.2 m";
    EXPECT_NEAR(row("integrator_loss"), 0, 1e-4 * row("pin_work"));
    EXPECT_NEAR(row("energy") - start, row("pin_work") - row("damping_loss") - row("drag_loss"), 1e-4);
    EXPECT_EQ(row("hand_work"), 0);
}

TEST(MovingPins, WakeTheClothAndKeepItAwake) {
    Settings settings = turned_row();
    assign_all(settings, std::vector<std::string>{"drag=0.02", "structural.damping=0.5", "integrator=backward_euler",
                                                  "dt=0.0078125", "sleep_speed=0.01"});
    settings.pins[0].turns.clear();
    settings.pins[0].shift = {
        {0, {0, 0, 0}}, {5, {0, 0, 0}}, {6, {0, 0, 0}}, {10, {0, 0, Real(0.01)}}};  // slower than sleep
    Simulation simulation("pins", std::move(settings));
    run_until(simulation, 4.9);
    ASSERT_TRUE(simulation.report().asleep);
    run_until(simulation, 6.1);
    EXPECT_FALSE(simulation.report().asleep);
    run_until(simulation, 9.9);
    EXPECT_FALSE(simulation.report().asleep);
    run_until(simulation, 14);
    EXPECT_TRUE(simulation.report().asleep);
    EXPECT_NEAR(position_of(simulation, 0).z(), 0.01, 1e-5);
}

TEST(MovingPins, GoBackToTheirWayOnceTheHandLetsGo) {
    Simulation simulation("pins", turned_row());
    run_until(simulation, 0.2);
    send(simulation, "grab 0 0");
    send(simulation, "drag -0.6 0.4 0.3");
    run_until(simulation, 0.5);
    send(simulation, "release");
    Real fastest = 0;
    run_until(simulation, 2, [&] { fastest = std::max(fastest, simulation.cloths()[0].state.v.row(0).norm()); });
    EXPECT_LT(off_by_the_end(simulation), 2e-6);
    EXPECT_LT(fastest, 6) << "no faster than a hand and the way together";
}

TEST(MovingPins, ThatAreBadAreRefusedWithTheirLine) {
    const std::pair<std::string, const char*> cases[] = {
        {"cloth = 1", "6:9: pins.cloth = 1: allowed 0 <= cloth <= 0"},
        {"cloth = -1", "6:9: pins.cloth = -1: allowed whole 0 <= cloth <= 63"},
        {"particles = [0, 16]", "6:13: pins.particles = [0, 16]: allowed 0 <= first <= second <= 15"},
        {"particles = [3, 2]", "6:13: pins.particles = [3, 2]: allowed 0 <= first <= second <= 15"},
        {"particles = [4, 15]", "6:13: pins.particles = [4, 15]: allowed only where cloth.pinned pins some"},
        {"particles = [0, nan]", "6:13: pins.particles = [0, nan]: allowed two whole numbers"},
        {"shift = [[0, 0, 0, 0]]", "6:9: pins.shift: allowed only at least two points"},
        {"shift = [[0, 0, 0, 0], [0, 1, 0, 0]]", "6:9: pins.shift: time 0: allowed only times that ascend"},
        {"shift = [[0, 1, 0, 0], [1, 1, 0, 0]]", "6:9: pins.shift begins with [1, 0, 0]: allowed only 0, 0, 0"},
        {"turns = [[0, 0, 0, 0], [1, inf, 0, 0]]", "6:9: pins.turns = [0, 0, 0, 0, 1, inf, 0, 0]: allowed rows"},
        {"turns = [[0, 0, 0, 0], [1, 2e4, 0, 0]]", "each -10000 <= x <= 10000 s, turns"},
        {"turns = [[0, 0, 0, 0], [1, 0.1, 0, 0], [0.5, 0, 0, 0]]", "6:9: pins.turns: time 0.5: allowed only"},
        {"turn = 3", "6:8: unknown key 'pins.turn': did you mean 'pins.turns'?"},
        {"particles = [0, 2]\n[[pins]]\nparticles = [2, 3]", "8:13: pins.particles = [2, 3]: allowed only part"}};
    for (const auto& [lines, message] : cases) {
        SCOPED_TRACE(lines);
        const std::string scene = "[cloth]\nparticles = [4, 4]\npinned = \"row\"\n\n[[pins]]\n" + lines;
        const std::string error = input_error_of([&scene] { parse_scene(scene, "s.toml"); });
        EXPECT_THAT(error, HasSubstr(message));
        EXPECT_THAT(error, testing::StartsWith("s.toml:"));
    }
}

TEST(MovingPins, EndWithTheLastOfTheirParticles) {
    Settings settings = turned_row();
    settings.pins[0].particles = {0, 1};
    Simulation simulation("pins", std::move(settings));
    run_until(simulation, 0.2);
    send(simulation, "pin 0 0");
    EXPECT_EQ(simulation.settings().pins.size(), 1u);
    send(simulation, "pin 0 1");
    EXPECT_TRUE(simulation.settings().pins.empty());
    EXPECT_TRUE(simulation.cloths()[0].model.pinned(2));
}

TEST(MovingPins, LetTheClothGoWithAllOthers) {
    Simulation simulation("twist", load_scene("twist"));
    run_until(simulation, 0.3);
    const std::uint64_t before = simulation.hash();
    const Vec3 corner = position_of(simulation, 0);
    send(simulation, "set cloth.pinned=none");
    EXPECT_TRUE(simulation.settings().pins.empty());
    EXPECT_EQ(position_of(simulation, 0), corner) << "it goes on from where it is";
    EXPECT_NE(simulation.hash(), before) << "the pins' velocities are part of the state";
    run_until(simulation, 0.5);
    EXPECT_LT(position_of(simulation, 0).y(), corner.y() - Real(0.1)) << "it falls";
    EXPECT_EQ(simulation.report().status, Status::Ok);
}

Simulation pinned_simulation() { return small_simulation({"cloth.pinned=0,5", "ball.position=0,-50,0"}); }

TEST(PinCommand, HoldsAParticleWhereItIs) {
    Simulation simulation = pinned_simulation();
    make_steps(simulation, 200);
    const Vec3 before = position_of(simulation, 40);
    send(simulation, "pin 0 40");
    make_steps(simulation, 200);
    EXPECT_EQ(position_of(simulation, 40), before);
    EXPECT_THAT(simulation.settings().cloths[0].pinned.list, testing::ElementsAre(0, 5, 40));
}

TEST(PinCommand, FreesAPinnedParticle) {
    Simulation simulation = pinned_simulation();
    make_steps(simulation, 200);
    const std::uint64_t before = simulation.hash();
    send(simulation, "pin 0 5");
    EXPECT_EQ(simulation.hash(), before);
    const Vec3 held = position_of(simulation, 0), freed = position_of(simulation, 5);
    make_steps(simulation, 200);
    EXPECT_EQ(position_of(simulation, 0), held);
    EXPECT_LT(position_of(simulation, 5).y(), freed.y() - Real(0.01));
    send(simulation, "pin 0 0");
    EXPECT_EQ(simulation.settings().cloths[0].pinned, Pins{});
}

TEST(PinCommand, CountsForWhatTheHandHolds) {
    Simulation simulation = pinned_simulation();
    send(simulation, "grab 0 0");
    send(simulation, "set cloth.pinned=none");
    EXPECT_TRUE(simulation.settings().cloths[0].pinned.list.empty());
    send(simulation, "release");
    EXPECT_FALSE(simulation.cloths()[0].model.pinned(0));
    send(simulation, "grab 0 40");
    send(simulation, "pin 0 40");
    send(simulation, "release");
    EXPECT_TRUE(simulation.cloths()[0].model.pinned(40));
}

TEST(PinCommand, AndGrabNameWhatThereIsWhereThereIsNoSuchParticle) {
    Simulation simulation = pinned_simulation();
    for (const std::string word : {"pin", "grab"}) {
        EXPECT_THAT(input_error_of([&] { send(simulation, word + " 1 0"); }),
                    testing::AllOf(HasSubstr(word + ": cloth 1"), HasSubstr("0 to 0")));
        EXPECT_THAT(input_error_of([&] { send(simulation, word + " 0 80"); }),
                    testing::AllOf(HasSubstr(word + ": particle 80"), HasSubstr("0 to 79")));
    }
    EXPECT_THAT(simulation.settings().cloths[0].pinned.list, testing::ElementsAre(0, 5));
}

}  // namespace
}  // namespace drape
