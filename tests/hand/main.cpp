// random_hand [--commands N] [--seed K]: pulls at the cloth of several scenes and moves their balls, at random, and
// holds to the checks below after every step; now and then lets go, and holds the cloth to what it is at rest.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>

#include "drape/contact/detection.h"
#include "drape/model/energy.h"
#include "drape/model/stencils.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "support/random_user.h"

namespace drape::random_hand {
namespace {

/// What is seen of the cloths of a simulation after a step.
struct Sight {
    Real stretch = -1;                                    ///< of the longest spring, relative
    Real deepest = 0;                                     ///< in a ball [m]
    Real lowest = std::numeric_limits<Real>::infinity();  ///< above the ground [m]
    Real farthest = 0;                                    ///< largest coordinate [m]
    bool finite = true;

    explicit Sight(const Simulation& simulation) {
        for (const Cloth& cloth : simulation.cloths()) {
            const Points& x = cloth.state.x;
            stretch = std::max(stretch, largest_stretch(cloth.model, x));
            deepest = std::max(deepest, deepest_penetration(cloth.model.grid, x, simulation.balls(), 0));
            lowest = std::min(lowest, x.col(1).minCoeff() - simulation.settings().ground.height);
            farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
            finite = finite && x.allFinite() && cloth.state.v.allFinite();
        }
    }
};

/// Contact comes after the limit, and may stretch a spring until the next step by what it pushes out.
constexpr Real pushed = Real(0.08);

/// Contact stops cloth at its thickness already. But a ball that the keys press onto the ground leaves cloth between
/// the two no room, and contact with one pushes it by as much into the other [m].
constexpr Real entered = Real(0.003);

/// Farther away no hand and no ball can have taken the cloth [m].
constexpr Real far_away = 20;

/// @return what is not so of what must be true after every step, whatever hand and ball do; empty if all is
std::string flaw_of(const Simulation& simulation, const Sight& sight) {
    const Real limit = simulation.cloths()[0].model.stretch_limit + stretch_tolerance + pushed;
    if (!sight.finite) return "the cloth is finite";
    if (!(sight.farthest < far_away)) return "nothing of the cloth is far away";
    if (!(sight.deepest <= entered)) return "no cloth is inside a ball";
    if (simulation.settings().ground.solid && !(sight.lowest >= -entered)) return "no cloth is below the ground";
    if (!(sight.stretch <= limit)) return "no spring is stretched beyond the limit";
    if (simulation.report().status != Status::Ok) return "the run goes on";
    return simulation.report().energy_gain_step == 0 ? "" : "no energy comes from nowhere";
}

/// How far structural springs are from their rest lengths, of those lengths, RMS.
Real strain_of(const Cloth& cloth) {
    Real squares = 0, count = 0;
    for (const SpringStencil& springs : spring_stencils(cloth.model)) {
        if (!springs.structural()) continue;
        springs.for_each(cloth.model.grid, [&](int a, int b) {
            const Real length = (cloth.state.x.row(a) - cloth.state.x.row(b)).norm();
            const Real difference = length / springs.rest_length - 1;
            squares += difference * difference;
            count += 1;
        });
    }
    return std::sqrt(squares / count);
}

/// How near in the mean a cloth comes back to its rest lengths. A single spring may stay farther from its own, within
/// the limit: where cloth is crumpled, cells that are folded across a diagonal stay so, and pull at those around them.
constexpr Real at_rest = Real(0.02);

/// A shipped scene in air so thick that its cloth comes to rest soon, with a ball under the keys.
Settings scene_with_a_ball(const std::string& name) {
    Settings settings = load_scene(name);
    settings.cloths[0].drag = Real(2e-3);
    settings.solver.sleep_speed = 0;
    if (settings.balls.empty()) {
        BallSettings& ball = settings.balls.emplace_back();
        ball.radius = Real(0.15);
        ball.position = Vec3(0, Real(0.6), Real(-0.5));
    }
    settings.balls[0].motion = BallMotion::Keys;
    return settings;
}

class RandomHand : test::RandomUser {
public:
    RandomHand(unsigned long seed, const std::string& scene)
        : RandomUser(seed, {scene, scene_with_a_ball(scene)}), start_(simulation.cloths()[0].state.x) {
        run(settling_time);
    }

    /// A round of commands, and what comes of it at rest. @return commands
    int play_round();

    [[nodiscard]] int failed() const { return failed_; }

private:
    static constexpr double settling_time = 2, rest_time = 5;  // s, before the first command and after the last

    std::string random_command();
    void run(double seconds);
    void fail(const std::string& what);
    [[nodiscard]] bool pins_are_in_place() const;

    Points start_;  ///< positions at the start
    int failed_ = 0;
};

std::string RandomHand::random_command() {
    const Settings& settings = simulation.settings();
    const Vec3 home = settings.balls[0].position - simulation.balls()[0].centre;
    const auto particles = static_cast<std::size_t>(settings.cloths[0].particles.particles());
    // Not out of sight
    const std::string steer = "steer" + (home.norm() > Real(0.6) ? vector(0.1, home) : vector(1));
    const std::string drag = "drag" + vector(1.2, settings.cloths[0].centre());
    const std::string grab = "grab 0 " + std::to_string(below(particles));
    const std::string commands[] = {grab, "hold 0", drag, drag, drag, "release", steer, steer, "steer 0 0 0"};
    return commands[below(std::size(commands))];
}

void RandomHand::fail(const std::string& what) {
    ++failed_;
    const Sight sight(simulation);
    std::cout << "stretch " << sight.stretch << ", " << sight.deepest << " m into a ball, lowest at " << sight.lowest
              << " m\n";
    RandomUser::fail("FAILED: " + what);
}

void RandomHand::run(double seconds) {
    const double end = simulation.report().time + seconds;
    while (simulation.report().time < end) {
        simulation.step();
        const std::string flaw = flaw_of(simulation, Sight(simulation));
        if (!flaw.empty()) return fail(flaw);
    }
}

/// A pin that the hand has had stays where it was left, and the cloth about it may be drawn taut for good.
bool RandomHand::pins_are_in_place() const {
    const Cloth& cloth = simulation.cloths()[0];
    for (int p = 0; p < cloth.model.grid.particles(); ++p) {
        if (cloth.model.pinned(p) && (cloth.state.x.row(p) - start_.row(p)).norm() > Real(1e-3)) return false;
    }
    return true;
}

int RandomHand::play_round() {
    constexpr int commands = 120;
    for (int c = 0; c < commands; ++c) {
        send(random_command());
        run(between(0, below(16) == 0 ? 0.6 : 0.03));  // now and then long enough to come where it leads
    }
    // A ball that leans on a cloth that hangs would stretch it
    const bool hangs = simulation.settings().cloths[0].pinned.kind != Pins::Kind::None;
    for (const char* command : {"release", "steer 0 0 0", hangs ? "set ball.position=9,1,0" : "steer 0 0 0"}) {
        send(command);
    }
    run(rest_time);
    if (pins_are_in_place() && strain_of(simulation.cloths()[0]) > at_rest) {
        fail("the cloth at rest has its rest lengths");
    }
    // A cloth that has fallen off is far away
    send("reset");
    return commands;
}

int run(int argc, char** argv) {
    long long wanted = 120;
    unsigned long seed = 1;
    for (int a = 1; a + 1 < argc; a += 2) {
        const std::string name = argv[a];
        if (name == "--commands") wanted = std::stoll(argv[a + 1]);
        if (name == "--seed") seed = std::stoul(argv[a + 1]);
    }
    std::vector<RandomHand> hands;
    for (const char* scene : {"drop", "hang", "original"}) hands.emplace_back(seed++, scene);
    long long commands = 0;
    while (commands < wanted) {
        for (RandomHand& hand : hands) commands += hand.play_round();
    }
    int failed = 0;
    for (const RandomHand& hand : hands) failed += hand.failed();
    std::printf("%lld commands, %d failed\n", commands, failed);
    std::printf("result,commands of a random hand,%lld,%d\n", commands, failed);
    return failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace drape::random_hand

int main(int argc, char** argv) { return drape::random_hand::run(argc, argv); }
