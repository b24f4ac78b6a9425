// Counts crossings exactly after every step, or every so many. First each scene that folds by itself for --time
// seconds, with each grid, each integrator that is stable there and the settings that are given; then each scene that
// has self contact and no more than 10,000 particles for --play seconds more, as it is shipped but for these settings,
// while hand, keys, pins and wind do at random what a user may do. Exit code 1 where cloth has crossed cloth, a run has
// come to an end before its time, or there was no step at all; 2 for bad input.

#include <algorithm>
#include <cstdio>
#include <optional>

#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/run_program.h"
#include "drape/base/stopwatch.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "self_scenes.h"
#include "support/random_user.h"
#include "support/scene_crossings.h"

namespace drape::crossings {
namespace {

struct Options {
    std::vector<std::string> scenes, played, integrators, assignments;
    std::vector<int> sides;
    double time = 0, play = 0;  ///< simulated [s]
    double drags = 0;           ///< that a hand sends on its way from one command to the next [1/s]
    bool self = true;
    unsigned long seed = 1, every = 1;
};

/// @return the number that a whole text is; 0 if it is empty
/// @throws InputError where it is none, or not positive
double positive(const std::string& name, const std::string& value) {
    if (value.empty()) return 0;
    const std::optional<double> number = parse_real(value);
    if (!number || !(*number > 0)) throw InputError(name + " " + value + ": allowed is a number above 0");
    return *number;
}

/// What was seen after the steps of a run.
struct Tally {
    std::int64_t steps = 0, crossed = 0, pairs = 0, held_back = 0, commands = 0;
    int ended = 0;  ///< runs that came to their end before their time
    std::string error;
    std::int64_t every = 1;  ///< steps from one count to the next
    test::SceneCrossings oracle;

    /// @return whether nothing has crossed
    bool look(const Simulation& simulation) {
        ++steps;
        pairs += simulation.report().pairs;
        held_back += simulation.report().failsafe_particles;
        if (simulation.report().status != Status::Ok) ++ended, error = simulation.report().error;
        if (steps % every != 0) return true;
        const std::int64_t count = oracle.count(simulation.cloths());
        if (count > 0) ++crossed;
        return count == 0;
    }

    void tell(const std::string& what, double simulated, double seconds) const {
        std::printf(
            "%s: %.3f s, %lld commands, %lld steps, %lld with crossings, %lld pairs answered, %lld particles "
            "held back, %d ended, %.0f s of the clock\n",
            what.c_str(), simulated, static_cast<long long>(commands), static_cast<long long>(steps),
            static_cast<long long>(crossed), static_cast<long long>(pairs), static_cast<long long>(held_back), ended,
            seconds);
        if (!error.empty()) std::printf("  %s\n", error.c_str());
        std::fflush(stdout);
    }
};

/// A run that nobody touches. @return its tally; one without steps if the method is stable at none
Tally run(const Options& options, const std::string& scene, int side, const std::string& integrator) {
    Tally tally;
    tally.every = static_cast<std::int64_t>(options.every);
    const Stopwatch clock;
    Settings settings = scene_of_side(scene, side);
    settings.contact.self = options.self;
    if (!use_method(settings, value_named<IntegratorKind>(integrator).value())) return tally;
    assign_all(settings, options.assignments);
    Simulation simulation(scene, std::move(settings));
    while (simulation.report().time < options.time && simulation.report().status == Status::Ok) {
        simulation.step();
        tally.look(simulation);
    }
    tally.tell(scene + ", " + std::to_string(side) + " a side, " + integrator, simulation.report().time,
               clock.seconds());
    return tally;
}

/// What a user may do, at random.
class Player : test::RandomUser {
public:
    Player(const Options& options, const std::string& scene)
        : RandomUser(options.seed, {scene, scene_of(scene, options.assignments)}),
          options_(options),
          as_shipped_(simulation) {}

    Tally play() {
        Tally tally;
        tally.every = static_cast<std::int64_t>(options_.every);
        const Stopwatch clock;
        double played = 0;
        while (played < options_.play) {
            const std::string command = next_command();
            command == "reset" ? begin_again() : send(command);
            ++tally.commands;
            const double start = simulation.report().time, end = start + between(0, below(8) == 0 ? 0.8 : 0.05);
            double now = start;
            bool good = true;
            while (now < end && good) {
                if (options_.drags > 0 && between(0, 1) < options_.drags * simulation.settings().solver.dt) {
                    send(next_drag());
                    ++tally.commands;
                }
                simulation.step();
                now = simulation.report().time;
                good = simulation.report().status == Status::Ok;
                if (!tally.look(simulation)) {
                    fail("CROSSED:");
                    good = false;
                }
            }
            played += now - start;
            if (!good) begin_again();
        }
        tally.tell(simulation.scene() + ", played with", played, clock.seconds());
        return tally;
    }

private:
    static Settings scene_of(const std::string& scene, const std::vector<std::string>& assignments) {
        Settings settings = scene_of_side(scene, 0);
        settings.solver.sleep_speed = 0;
        assign_all(settings, assignments);
        if (settings.balls.empty()) {
            BallSettings& ball = settings.balls.emplace_back();
            ball.radius = Real(0.1);
            ball.position = Vec3(0, Real(0.3), Real(0.5));
        }
        return settings;
    }

    /// With the scene's own pins and settings.
    void begin_again() {
        simulation = as_shipped_;
        send("reset");
    }

    /// From outside the cloth, to somewhere near its middle.
    std::string throw_ball() {
        Vec3 from(1, 0, 0);
        for (Real& place : from) place = static_cast<Real>(between(-1, 1));
        from *= Real(2.5) / std::max(from.norm(), Real(0.1));
        from.y() = std::abs(from.y());
        return "throw" + vector(0, from) + vector(1, -2 * from);
    }

    std::string particle() {
        const std::size_t cloth = below(simulation.cloths().size());
        const auto count = static_cast<std::size_t>(simulation.cloths()[cloth].model.grid.particles());
        return " " + std::to_string(cloth) + " " + std::to_string(below(count));
    }

    /// The hand goes on, a little at random.
    std::string next_drag() {
        for (Real& place : hand_)
            place = std::clamp(place + static_cast<Real>(between(-0.03, 0.03)), Real(-1), Real(1));
        return "drag" + vector(0, hand_);
    }

    std::string next_command() {
        const std::size_t chosen = below(24);
        if (chosen == 0) return "reset";
        if (chosen == 1) return throw_ball();
        if (chosen == 2) return "fall";
        if (chosen < 5) return chosen == 3 ? "set wind.on=true" : "set wind.on=false";
        if (chosen == 5) return "pin" + particle();
        if (chosen < 8) return "release";
        if (chosen < 11) return "grab" + particle();
        if (chosen < 14) return "steer" + vector(1);
        return chosen == 14 ? "steer 0 0 0" : "drag" + vector(0.8);
    }

    const Options& options_;
    Simulation as_shipped_;
    Vec3 hand_ = Vec3::Zero();  ///< where it was sent last [m]
};

int count(const Options& options) {
    std::int64_t steps = 0, crossed = 0, commands = 0;
    int ended = 0;
    const auto add = [&](const Tally& tally) {
        steps += tally.steps, crossed += tally.crossed, commands += tally.commands;
        ended += tally.ended;
    };
    for (const int side : options.sides) {
        for (const std::string& scene : options.scenes) {
            for (const std::string& integrator : options.integrators) add(run(options, scene, side, integrator));
        }
    }
    for (const std::string& scene : options.played) {
        if (options.play > 0) add(Player(options, scene).play());
    }
    std::printf("%lld commands\n", static_cast<long long>(commands));
    std::printf("result,steps of scenes of self contact that are searched for crossings,%lld,%lld\n",
                static_cast<long long>(steps), static_cast<long long>(crossed));
    return crossed == 0 && ended == 0 && steps > 0 ? 0 : 1;
}

int run_all(int argc, char** argv) {
    std::vector<std::string> scenes = scene_names();
    std::erase_if(scenes, [](const std::string& name) {
        const Settings settings = load_scene(name);  // to count all of a large cloth takes a second a step
        return !settings.contact.self || settings.cloths[0].particles.particles() > 10'000;
    });
    const std::vector<std::string> integrators{names_of<IntegratorKind>().begin(), names_of<IntegratorKind>().end()};
    Options options;
    std::vector<std::string> sides;
    std::string time, play, seed = "1", every = "1", drags;
    bool without = false;
    CommandLine line("count_crossings", "Counts where cloth crosses cloth in the scenes of self contact.");
    line.option(
        "--scene", options.scenes,
        "Else fold, stack, twist and pinch, and to play with all that have self contact and at most 10000 particles",
        {"NAME", false, scenes});
    line.option("--integrator", options.integrators, "All, if none is named", {"NAME", false, integrators});
    line.option("--set", options.assignments, "As in drape-lab", {"NAME=VALUE"});
    line.option("--side", sides, "Particles along each side of a grid", {"N"});
    line.option("--time", time, "Simulated time of each run", {"SECONDS"});
    line.option("--play", play, "Simulated time for which each scene is played with", {"SECONDS"});
    line.option("--drags", drags, "That a player's hand sends a second besides, on its way", {"RATE"});
    line.option("--every", every, "Steps from one count of crossings to the next", {"N"});
    line.option("--seed", seed, "Of what is done at random", {"K"});
    line.flag("--without-self", without, "Without contact between cloths");
    if (!line.parse(argc, argv)) return Done;
    options.played = options.scenes.empty() ? scenes : options.scenes;
    if (options.scenes.empty()) options.scenes = {"fold", "stack", "twist", "pinch"};
    if (options.integrators.empty()) options.integrators = integrators;
    for (const std::string& side : sides) options.sides.push_back(static_cast<int>(positive("--side", side)));
    options.time = positive("--time", time);
    options.play = positive("--play", play);
    options.seed = static_cast<unsigned long>(positive("--seed", seed));
    options.drags = positive("--drags", drags);
    options.every = std::max(1UL, static_cast<unsigned long>(positive("--every", every)));
    options.self = !without;
    return count(options);
}

}  // namespace
}  // namespace drape::crossings

int main(int argc, char** argv) { return drape::run_program("count_crossings", argc, argv, drape::crossings::run_all); }
