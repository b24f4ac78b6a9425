#include <fmt/core.h>

#include <array>

#include "drape/base/input_error.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// One stage of a frame by one kind of kernels on one cloth.
struct KernelsRow {
    std::string stage, kernels;
    double particles = 0;
    Quartiles time = {};  ///< over steps [s]
};

struct Stage {
    const char* name;
    double StageTimes::*time;
};
constexpr std::array<Stage, 4> stages{{{"step", &StageTimes::step},
                                       {"build", &StageTimes::build},
                                       {"query", &StageTimes::traverse},
                                       {"narrow_phase", &StageTimes::narrow}}};

/// A cloth that lies on a ball from the start and has no time to move: each step does the same work.
Simulation touching_cloth(int side, const std::string& kernels) {
    Settings settings = load_scene("drop");
    settings.cloths[0].particles = {side, side};
    const std::vector<std::string> assignments{"solver.kernels=" + kernels,
                                               "solver.integrator=velocity_verlet",
                                               "solver.dt=1e-6",
                                               "sleep_speed=0",
                                               "ledger=false",
                                               "ball.position=0,-0.29,0"};
    assign_all(settings, assignments);
    settings.cloths[0].centred = true;
    settings.cloths[0].place = Vec3::Zero();
    return {"drop", settings};
}

std::vector<KernelsRow> run_kernels_case(int side, int steps) {
    std::array<Simulation, 2> simulations{touching_cloth(side, names_of<Kernels>()[0]),
                                          touching_cloth(side, names_of<Kernels>()[1])};
    std::array<std::array<std::vector<double>, stages.size()>, enum_names<Kernels>.size()> times;
    // In turn: a machine has faster and slower moments. The first steps warm the caches
    for (int step = -2; step < steps; ++step) {
        for (std::size_t k = 0; k < simulations.size(); ++k) {
            simulations[k].step();
            const StepReport& report = simulations[k].report();
            if (report.traversal.candidates == 0) throw RunError("kernels: the cloth is not at the ball");
            for (std::size_t s = 0; s < stages.size() && step >= 0; ++s) {
                times[k][s].push_back(report.times.*stages[s].time);
            }
        }
    }
    std::vector<KernelsRow> rows;
    for (std::size_t s = 0; s < stages.size(); ++s) {
        for (std::size_t k = 0; k < simulations.size(); ++k) {
            rows.push_back(
                {stages[s].name, names_of<Kernels>()[k], static_cast<double>(side) * side, quartiles_of(times[k][s])});
        }
    }
    return rows;
}

std::vector<CaseOf<KernelsRow>> kernels_cases(bool quick) {
    std::vector<CaseOf<KernelsRow>> all;
    for (const int side : quick ? std::vector{16, 32, 64} : std::vector{16, 32, 64, 128, 256}) {
        all.push_back([=] { return run_kernels_case(side, quick ? 31 : 201); });
    }
    return all;
}

RowFormat<KernelsRow> kernels_format() {
    using Row = KernelsRow;
    return {6,
            {{word_column("stage", names_in(stages, &Stage::name)), &Row::stage},
             {name_column<Kernels>("kernels"), &Row::kernels},
             {whole_column("particles", 4), &Row::particles},
             {number_column("time_s"), &Row::time}}};
}

/// Plain over vector for each stage and size.
template <class Tell>
void tell_ratios(const std::vector<KernelsRow>& rows, const Tell& tell) {
    for (const KernelsRow& plain : rows_with(rows, &KernelsRow::kernels, "plain")) {
        for (const KernelsRow& vector : rows_with(rows, &KernelsRow::kernels, "vector")) {
            const bool same = vector.stage == plain.stage && vector.particles == plain.particles;
            if (same && vector.time.median > 0) tell(plain, plain.time.median / vector.time.median);
        }
    }
}

std::string kernels_summary(const std::vector<KernelsRow>& rows) {
    std::string text;
    tell_ratios(rows, [&text](const KernelsRow& plain, double ratio) {
        text += fmt::format("{}, {} particles: plain {:.3g} us, {:.3g} times vector\n", plain.stage, plain.particles,
                            1e6 * plain.time.median, ratio);
    });
    return text;
}

std::vector<Chart> kernels_charts(const std::vector<KernelsRow>& rows) {
    std::string ratios = "stage,particles,ratio\n";
    tell_ratios(rows, [&ratios](const KernelsRow& plain, double ratio) {
        ratios += fmt::format("{},{},{:.6g}\n", plain.stage, plain.particles, ratio);
    });
    return {{"kernels",
             "kernels",
             "Wall time of the stages of a step by vector kernels and by the plain core, medians with quartiles over "
             "steps that were made in turn, and how many times as long the plain core takes.",
             {{"stages", in_words(words_of(rows, &KernelsRow::stage))}},
             ratios}};
}

}  // namespace

Experiment kernels_experiment() {
    return ExperimentOf<KernelsRow>{
        "kernels", "what do the vector kernels buy?", kernels_format(), kernels_cases, kernels_charts, kernels_summary}
        .as_table();
}

}  // namespace drape
