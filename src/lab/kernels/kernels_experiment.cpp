#include <array>

#include "drape/base/input_error.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"

namespace drape {
namespace {

struct Stage {
    const char* name;
    double StageTimes::*time;
};
constexpr Stage stages[] = {{"step", &StageTimes::step},
                            {"build", &StageTimes::build},
                            {"query", &StageTimes::traverse},
                            {"narrow_phase", &StageTimes::narrow}};

/// A cloth that lies on a ball from the start and has no time to move: each step does the same work.
Simulation touching_cloth(int side, Kernels kernels) {
    Settings settings = load_scene("drop");
    assign_all(settings,
               std::vector<std::string>{"solver.integrator=velocity_verlet", "solver.dt=1e-6", "sleep_speed=0",
                                        "ledger=false", "contact.self=false", "ball.position=0,-0.29,0"});
    settings.solver.kernels = kernels;
    settings.cloths[0].particles = {side, side};
    settings.cloths[0].centred = true;
    settings.cloths[0].place = Vec3::Zero();
    return {"drop", settings};
}

Rows run_kernels_case(int side, int steps) {
    std::array simulations{touching_cloth(side, Kernels::Vector), touching_cloth(side, Kernels::Plain)};
    std::array<std::vector<StageTimes>, simulations.size()> times;
    // In turn: a machine has faster and slower moments. The first steps warm the caches
    for (int step = -2; step < steps; ++step) {
        for (std::size_t k = 0; k < simulations.size(); ++k) {
            simulations[k].step();
            const StepReport& report = simulations[k].report();
            if (report.traversal.candidates == 0) throw RunError("kernels: the cloth is not at the ball");
            if (step >= 0) times[k].push_back(report.times);
        }
    }
    Rows rows;
    for (const Stage& stage : stages) {
        for (std::size_t k = 0; k < simulations.size(); ++k) {
            std::vector<double> seconds;
            for (const StageTimes& one : times[k]) seconds.push_back(one.*stage.time);
            rows.push_back({{"stage", stage.name},
                            {"kernels", simulations[k].settings().solver.kernels},
                            {"particles", side * side},
                            {"time_s", quartiles_of(std::move(seconds))}});
        }
    }
    return rows;
}

}  // namespace

Experiment kernels_experiment() {
    const auto cases = [](bool quick) {
        return cases_over([=](int side) { return run_kernels_case(side, quick ? 31 : 201); },
                          quick ? std::vector{16, 32, 64} : std::vector{16, 32, 64, 128, 256});
    };
    return {"kernels",
            "what do the vector kernels buy?",
            6,
            {word_column("stage", names_in(stages, &Stage::name)), name_column<Kernels>("kernels"),
             whole_column("particles", 4), number_column("time_s").with_quartiles()},
            {{"stage", "particles", "kernels"}, {"time_s"}},
            {{"", cases, {{"kernels"}}}}};
}

}  // namespace drape
