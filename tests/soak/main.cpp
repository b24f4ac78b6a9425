// soak [--steps N] [--seed K]: runs scenes under every method with random commands, replays what was
// recorded, and holds the two runs to the same bits. Ends when N steps have been made, those of replays included.

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/integrate/integrator.h"
#include "drape/scene/scene.h"
#include "drape/session/start.h"
#include "support/random_user.h"

namespace drape::soak {
namespace {

/// What a run came to.
struct End {
    std::uint64_t hash;
    std::int64_t step;
    Status status;
    bool operator==(const End&) const = default;
};

End end_of(Session& session) {
    const StepReport& report = session.simulation().report();
    return {session.simulation().hash(), report.step, report.status};
}

bool finite(Session& session) {
    for (const Cloth& cloth : session.simulation().cloths()) {
        if (!cloth.state.x.allFinite() || !cloth.state.v.allFinite()) return false;
    }
    return true;
}

class Soak : test::Chance {
public:
    Soak(unsigned long seed, std::filesystem::path file) : Chance(seed), file_(std::move(file)) {}

    /// One run of a scene and its replay. @return steps that were made
    long long run_twice();

    [[nodiscard]] int runs() const { return runs_; }
    [[nodiscard]] int failed() const { return failed_; }

private:
    template <class List>
    const auto& one_of(const List& list) {
        return list[below(list.size())];
    }
    std::string random_command(const Simulation& simulation);
    std::vector<std::string> random_assignments();
    void fail(const std::string& what);

    std::filesystem::path file_;
    std::vector<std::string> scenes_ = scene_names();
    std::string about_;
    int runs_ = 0, failed_ = 0;
};

std::vector<std::string> Soak::random_assignments() {
    const std::size_t side = 5 + below(10);
    const std::string method(one_of(names_of<IntegratorKind>()));
    // From far below any limit to far above most
    const double dt = std::pow(10, between(-4.3, -2.3));
    return {"cloth.particles=" + std::to_string(side) + "," + std::to_string(5 + below(10)),
            "cloth.pinned=" + std::string(below(2) == 0 ? "two" : "none"),
            "integrator=" + method,
            "dt=" + real_text(dt),
            "iterations=" + std::to_string(1 + below(12)),
            "threads=" + std::to_string(1 + below(2)),
            "sleep_speed=" + std::string(below(2) == 0 ? "0" : "2e-4"),
            "on_unstable=" + std::string(below(4) == 0 ? "stop" : "warn"),
            "volume=" + std::string(one_of(names_of<VolumeKind>())),
            "update=" + std::string(one_of(names_of<UpdateKind>()))};
}

std::string Soak::random_command(const Simulation& simulation) {
    const auto number = [&] { return real_text(between(-1, 1)); };
    const std::vector<std::string> others{"contact.volume",   "contact.update", "contact.sphere_fit",
                                          "contact.response", "solver.hessian", "solver.ledger"};
    return one_of(std::vector<std::string>{
        "grab 0 " + std::to_string(below(25)), "drag" + vector(1), "drag" + vector(1), "release", "steer" + vector(1),
        "steer 0 0 0", "next wind.on", "next " + one_of(others),
        below(4) == 0 ? "next solver.integrator" : "add contact.search_level -1",
        below(4) == 0 ? "reset" : "set contact.search_level=30", "set contact.friction=" + real_text(between(0, 1)),
        "set wind.velocity=" + number() + "," + number() + "," + number(),
        "set solver.dt=" + real_text(simulation.settings().solver.dt * between(0.7, 1.3)), "orbit 0.1 0.1"});
}

void Soak::fail(const std::string& what) {
    ++failed_;
    const auto kept = file_.string() + "." + std::to_string(failed_);
    // One that is still recorded has another name
    std::error_code none;
    for (const std::string& name : {file_.string() + ".unfinished", file_.string()}) {
        std::filesystem::copy_file(name, kept, std::filesystem::copy_options::skip_existing, none);
    }
    std::cout << "FAILED: " << what << "\n  " << about_ << "\n  the recording is " << kept << "\n";
}

long long Soak::run_twice() {
    constexpr int commands = 12;
    const std::string scene = one_of(scenes_);
    const std::vector<std::string> assignments = random_assignments();
    try {
        make_start({scene, assignments, {}});
    } catch (const InputError&) {
        return 0;  // refused: a smaller cloth lacks particles that are pinned
    }
    ++runs_;
    about_ = scene;
    for (const std::string& assignment : assignments) about_ += " --set " + assignment;
    long long made = 0;  // before the last reset
    End first{};
    {
        Session session = make_session(make_start({scene, assignments, {}}), file_.string());
        const Simulation& simulation = session.simulation();
        double time = 0;
        for (int c = 0; c < commands && simulation.report().status == Status::Ok; ++c) {
            const std::int64_t before = simulation.report().step;
            try {
                session.send(parse_command(random_command(simulation)));
            } catch (const InputError&) {
                // Refused, and not recorded: no such particle, no ball
            }
            if (simulation.report().step < before) made += before;
            // An adaptive step or an implicit one costs a hundred plain ones
            const bool plain = simulation.settings().solver.integrator <= IntegratorKind::Rk4;
            time += simulation.settings().solver.dt * static_cast<double>(below(plain ? 1500 : 100));
            session.run_until(time);
            if (!finite(session)) fail("a state that is not finite is shown");
        }
        session.close();
        first = end_of(session);
    }
    StartOptions again;
    again.replay = file_.string();
    Session session = make_session(make_start(again));
    session.run_replay();
    if (session.replay_differs()) fail(session.replay_notice());
    if (end_of(session) != first) fail("the replay ends elsewhere");
    return 2 * (made + first.step);
}

int run(int argc, char** argv) {
    long long wanted = 20'000;
    unsigned long seed = 1;
    for (int a = 1; a + 1 < argc; a += 2) {
        const std::string name = argv[a];
        if (name == "--steps") wanted = std::stoll(argv[a + 1]);
        if (name == "--seed") seed = std::stoul(argv[a + 1]);
    }
    const auto file = std::filesystem::temp_directory_path() / ("drape-soak-" + std::to_string(getpid()) + ".txt");
    Soak soak(seed, file);
    long long steps = 0;
    while (steps < wanted) steps += soak.run_twice();
    std::filesystem::remove(file);
    std::printf("%lld steps in %d runs and their replays, %d failed\n", steps, soak.runs(), soak.failed());
    std::printf("result,steps of soak,%lld,%d\n", steps, soak.failed());
    return soak.failed() > 0 ? 1 : 0;
}

}  // namespace
}  // namespace drape::soak

int main(int argc, char** argv) { return drape::soak::run(argc, argv); }
