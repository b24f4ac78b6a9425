// random_hand [--commands N] [--seed K]: pulls at the cloth of several scenes and moves their balls, at random, and
// holds to the checks below after every step; now and then lets go, and holds the cloth to what it is at rest.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <span>

#include "drape/base/numbers.h"
#include "drape/contact/search_audit.h"
#include "drape/model/energy.h"
#include "drape/model/stencils.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape::random_hand {
namespace {

/// What is seen of a simulation after a step.
struct Sight {
    Real stretch = 0;   ///< of the longest spring, relative
    Real deepest = 0;   ///< in a ball [m]
    Real lowest = 0;    ///< above the ground [m]
    Real farthest = 0;  ///< largest coordinate [m]
    bool finite = true;
};

/// What must be true after every step, whatever hand and ball do.
struct Check {
    const char* name;
    std::function<bool(const Simulation&, const Sight&)> holds;
};

bool is_finite(const Simulation& simulation) {
    return std::ranges::all_of(
        simulation.cloths(), [](const Cloth& cloth) { return cloth.state.x.allFinite() && cloth.state.v.allFinite(); });
}

Real stretch_of(const Simulation& simulation) {
    Real largest = -1;
    for (const Cloth& cloth : simulation.cloths()) {
        largest = std::max(largest, largest_stretch(cloth.model, cloth.state.x));
    }
    return largest;
}

/// Contact comes after the limit, and may stretch a spring until the next step by what it pushes out.
constexpr Real pushed = Real(0.08);

bool is_within_its_limit(const Simulation& simulation, const Sight& sight) {
    return sight.stretch <= simulation.cloths()[0].model.stretch_limit + stretch_tolerance + pushed;
}

/// Contact stops cloth at its thickness already. But a ball that the keys press onto the ground leaves cloth between
/// the two no room, and contact with one pushes it by as much into the other [m].
constexpr Real entered = Real(0.003);

Real deepest_in_balls(const Simulation& simulation) {
    Real deepest = 0;
    for (const Cloth& cloth : simulation.cloths()) {
        SearchAudit audit(cloth.model.grid, Kernels::Vector);
        deepest = std::max(deepest, audit.penetration(cloth.state.x, simulation.balls(), 0));
    }
    return deepest;
}

Real lowest_of(const Simulation& simulation) {
    Real lowest = std::numeric_limits<Real>::infinity();
    for (const Cloth& cloth : simulation.cloths()) lowest = std::min(lowest, cloth.state.x.col(1).minCoeff());
    return lowest;
}

bool is_above_the_ground(const Simulation& simulation, const Sight& sight) {
    return !simulation.settings().ground.solid || sight.lowest >= -entered;
}

/// Farther away no hand and no ball can have taken the cloth [m].
constexpr Real far_away = 20;

Real farthest_of(const Simulation& simulation) {
    Real farthest = 0;
    for (const Cloth& cloth : simulation.cloths()) farthest = std::max(farthest, cloth.state.x.cwiseAbs().maxCoeff());
    return farthest;
}

Sight look_at(const Simulation& simulation) {
    return {.stretch = stretch_of(simulation),
            .deepest = deepest_in_balls(simulation),
            .lowest = lowest_of(simulation) - simulation.settings().ground.height,
            .farthest = farthest_of(simulation),
            .finite = is_finite(simulation)};
}

const std::vector<Check>& checks() {
    static const std::vector<Check> list{
        {"the cloth is finite", [](const Simulation&, const Sight& sight) { return sight.finite; }},
        {"nothing of the cloth is far away",
         [](const Simulation&, const Sight& sight) { return sight.farthest < far_away; }},
        {"no cloth is inside a ball", [](const Simulation&, const Sight& sight) { return sight.deepest <= entered; }},
        {"no cloth is below the ground", is_above_the_ground},
        {"no spring is stretched beyond the limit", is_within_its_limit},
        {"the run goes on", [](const Simulation& s, const Sight&) { return s.report().status == Status::Ok; }},
        {"no energy comes from nowhere",
         [](const Simulation& s, const Sight&) { return s.report().energy_gain_step == 0; }}};
    return list;
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

class RandomHand {
public:
    RandomHand(unsigned long seed, const std::string& scene)
        : random_(seed), scene_(scene), simulation_(scene, scene_with_a_ball(scene)) {
        start_ = simulation_.cloths()[0].state.x;
        run(settling_time);
    }

    /// A round of commands, and what comes of it at rest. @return commands
    int play_round();

    [[nodiscard]] int failed() const { return failed_; }

private:
    static constexpr double settling_time = 2, rest_time = 5;  // s, before the first command and after the last

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    std::string random_vector(const Vec3& middle, double away);
    std::string random_command();
    void run(double seconds);
    void look();
    [[nodiscard]] bool pins_are_in_place() const;
    void fail(const std::string& what);

    std::mt19937_64 random_;
    std::string scene_;
    Simulation simulation_;
    Points start_;                   ///< positions at the start
    std::vector<std::string> done_;  ///< since the start
    int failed_ = 0;
};

std::string RandomHand::random_vector(const Vec3& middle, double away) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        text += " " + real_text(static_cast<double>(middle[axis]) + between(-away, away), 4);
    }
    return text;
}

std::string RandomHand::random_command() {
    const Settings& settings = simulation_.settings();
    const Vec3 middle = settings.cloths[0].centre(), home = settings.balls[0].position - simulation_.balls()[0].centre;
    switch (random_() % 8) {
        case 0:
            return "grab 0 " +
                   std::to_string(random_() % static_cast<unsigned>(settings.cloths[0].particles.particles()));
        case 1:
        case 2:
        case 3:
            return "drag" + random_vector(middle, 1.2);
        case 4:
            return "release";
        case 5:
        case 6:
            // Not out of sight
            return "steer" + (home.norm() > Real(0.6) ? random_vector(home, 0.1) : random_vector(Vec3::Zero(), 1));
        default:
            return "steer 0 0 0";
    }
}

void RandomHand::fail(const std::string& what) {
    ++failed_;
    std::cout << "FAILED: " << what << "\n  " << scene_ << ", step " << simulation_.report().step << ", stretch "
              << stretch_of(simulation_) << ", " << deepest_in_balls(simulation_) << " m into a ball, lowest at "
              << lowest_of(simulation_) << " m " << simulation_.report().error << simulation_.run_warning() << "\n";
    for (const std::string& command : done_) std::cout << "  " << command << "\n";
    simulation_.apply(command::Reset{});
    done_.clear();
}

void RandomHand::look() {
    const Sight sight = look_at(simulation_);
    for (const Check& check : checks()) {
        if (!check.holds(simulation_, sight)) return fail(check.name);
    }
}

void RandomHand::run(double seconds) {
    const double end = simulation_.report().time + seconds;
    while (simulation_.report().time < end) {
        const std::int64_t before = simulation_.report().step;
        simulation_.step();
        look();
        if (simulation_.report().step <= before) return;  // a check has failed
    }
}

/// A pin that the hand has had stays where it was left, and the cloth about it may be drawn taut for good.
bool RandomHand::pins_are_in_place() const {
    const Cloth& cloth = simulation_.cloths()[0];
    for (int p = 0; p < cloth.model.grid.particles(); ++p) {
        if (cloth.model.pinned(p) && (cloth.state.x.row(p) - start_.row(p)).norm() > Real(1e-3)) return false;
    }
    return true;
}

int RandomHand::play_round() {
    constexpr int commands = 120;
    for (int c = 0; c < commands; ++c) {
        const std::string command = random_command();
        done_.push_back(std::to_string(simulation_.report().step) + " " + command);
        simulation_.apply(parse_command(command));
        run(between(0, random_() % 16 == 0 ? 0.6 : 0.03));  // now and then long enough to come where it leads
    }
    // A ball that leans on a cloth that hangs would stretch it
    const bool hangs = simulation_.settings().cloths[0].pinned.kind != Pins::Kind::None;
    for (const char* command : {"release", "steer 0 0 0", hangs ? "set ball.position=9,1,0" : "steer 0 0 0"}) {
        done_.push_back(std::to_string(simulation_.report().step) + " " + command);
        simulation_.apply(parse_command(command));
    }
    run(rest_time);
    if (pins_are_in_place() && strain_of(simulation_.cloths()[0]) > at_rest) {
        fail("the cloth at rest has its rest lengths");
    }
    // A cloth that has fallen off is far away
    simulation_.apply(command::Reset{});
    done_.clear();
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
