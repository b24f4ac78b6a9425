#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "drape/base/input_error.h"
#include "drape/model/stencils.h"
#include "drape/scene/scene.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "lab/needs/needs.h"

namespace drape {
namespace {

/// What a square cloth of 1 m does, of any number of particles: its mass, its drag and its springs stay the same.
enum class FrameMotion {
    Free,  ///< falls, hung by two corners
    Ball,  ///< falls flat on a ball
    Fold   ///< falls upright on the ground and folds on itself
};

/// A method, and in how many steps it makes a frame; its name has both.
struct FrameMethod : Method {
    int steps = 1;
};

}  // namespace

namespace {

constexpr double frame = 1.0 / 60;    // s
constexpr double most_excess = 0.01;  // of the stretch, that a picture may have
constexpr int tried_sides[] = {16, 23, 32, 45, 64, 91, 128, 181, 256};

/// A method with a step limit makes one step, which is divided as its limit asks for.
std::vector<FrameMethod> frame_methods() {
    std::vector<FrameMethod> all;
    const auto add = [&](const char* name, int steps) {
        all.push_back({{fmt::format("{}_by_{}", name, steps), methods_named({name})[0].parameters}, steps});
    };
    for (const char* name : {"symplectic_euler", "velocity_verlet", "rk4"}) add(name, 1);
    for (const char* name : {"backward_euler_clamped", "bdf2_clamped"}) {
        for (const int steps : {1, 2, 4}) add(name, steps);
    }
    for (const int steps : {5, 10, 20, 40}) add("xpbd_1", steps);
    for (const char* name : {"xpbd_20", "projective_dynamics_10"}) add(name, 1);
    return all;
}

Settings settings_of(FrameMotion motion, const FrameMethod& method, int side, int threads) {
    constexpr const char* scenes[] = {"two_corners", "drop", "fold"};
    Settings settings = load_scene(scenes[static_cast<std::size_t>(motion)]);
    ClothParameters& cloth = settings.cloths[0];
    cloth.particles = {side, side};
    cloth.width = cloth.height = 1;
    cloth.mass = Real(0.2);
    cloth.structural = {800, Real(0.02)};
    cloth.shear = {200, Real(0.02)};
    cloth.bend = {5, Real(0.01)};
    cloth.drag = Real(0.7) / static_cast<Real>(cloth.particles.particles());
    cloth.stretch_limit = 0;  // what a method leaves of the springs is to be seen
    if (motion == FrameMotion::Free) settings.balls.clear();
    if (motion == FrameMotion::Fold) cloth.place += Vec3(Real(-0.1), Real(0.2), 0);  // the scene's sheet is smaller
    settings.contact.self = motion == FrameMotion::Fold;
    settings.solver.integrator = method.parameters.kind;
    settings.solver.hessian = method.parameters.hessian;
    settings.solver.iterations = method.parameters.iterations;
    settings.solver.threads = threads;
    settings.solver.dt = frame / method.steps;
    settings.solver.on_unstable = OnUnstable::Substep;
    settings.solver.sleep_speed = 0;
    settings.solver.ledger = false;
    settings.needs.horizon = Real(0.5);
    // How a sheet buckles is a matter of chance
    settings.needs.measure = motion == FrameMotion::Fold ? NeedsMeasure::CentreAndSpread : NeedsMeasure::Positions;
    return settings;
}

/// That all but a hundredth of the structural springs stay below at the end, of their length.
double stretch_of(const Settings& settings, const Motion& motion) {
    const ClothModel model = make_cloth_model(settings.cloths[0]);
    const Points& x = motion.x.back();
    std::vector<Real> all;
    for (const SpringStencil& springs : spring_stencils(model)) {
        if (!springs.structural()) continue;
        springs.for_each(model.grid,
                         [&](int a, int b) { all.push_back((x.row(a) - x.row(b)).norm() / springs.rest_length - 1); });
    }
    const auto high = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 99 / 100);
    std::ranges::nth_element(all, high);
    return static_cast<double>(*high);
}

/// The finest grid that can be waited for, by a method of second order at nine tenths of its limit.
Motion converged(FrameMotion motion, bool quick) {
    const FrameMethod method{{"converged", {.kind = IntegratorKind::VelocityVerlet}}, 1};
    Motion run = run_to_horizon(settings_of(motion, method, quick ? 45 : 181, 1));
    if (run.diverged) throw RunError(std::string("realtime: the reference of '") + name_of(motion) + "' has diverged");
    return run;
}

/// A cloth of one size by one method.
Row run_one(FrameMotion motion, const FrameMethod& method, int side, int threads, const Motion& truth) {
    constexpr double patience = 4;  // s/s
    const Settings settings = settings_of(motion, method, side, threads);
    const Motion run = run_to_horizon(settings, {.cost = patience * threads});
    Row row{{"motion", motion}, {"method", method.name}, {"threads", threads}, {"side", side}};
    row.set("end", run.diverged ? "diverged" : "late");
    if (run.diverged || run.given_up) return row;
    const double excess =
        std::max(stretch_of(settings, run) - stretch_of(settings_of(motion, method, truth.grid.nx, 1), truth), 0.0);
    row.set({{"wall_s_per_s", run.wall},
             {"cpu_s_per_s", run.cost},
             {"stretch_excess", excess},
             {"error", motion_error(run, truth, settings.needs.measure, 1)}});
    if (run.wall <= 1) row.set("end", excess <= most_excess ? "realtime" : "stretched");
    return row;
}

/// From small to large, until it is no longer real time.
Rows run_method(FrameMotion motion, const FrameMethod& method, int threads, bool quick, const Motion& truth) {
    Rows rows;
    for (const int side : tried_sides) {
        if (quick && side > 32) break;
        rows.push_back(run_one(motion, method, side, threads, truth));
        if (rows.back().word("end") == "late") break;
    }
    return rows;
}

ExperimentCases realtime_cases(bool quick) {
    ExperimentCases all;
    for (const FrameMotion motion : values_of<FrameMotion>()) {
        // Found when the first case asks for it
        const auto truth = std::make_shared<std::optional<Motion>>();
        for (const int threads : {1, 2}) {
            for (const FrameMethod& method : frame_methods()) {
                all.push_back([=] {
                    if (!*truth) *truth = converged(motion, quick);
                    return run_method(motion, method, threads, quick, **truth);
                });
            }
        }
    }
    return all;
}

/// Of some methods, that have a cloth in real time on one thread.
std::vector<Chart> realtime_charts(Rows rows) {
    const std::vector<std::string> charted{"symplectic_euler_by_1",
                                           "backward_euler_clamped_by_1",
                                           "backward_euler_clamped_by_4",
                                           "bdf2_clamped_by_2",
                                           "xpbd_1_by_10",
                                           "xpbd_1_by_40"};
    std::erase_if(rows, [&](const Row& row) {
        return row.word("end") != "realtime" || row.number("threads") != 1 ||
               std::ranges::find(charted, row.word("method")) == charted.end();
    });
    std::vector<Chart> charts;
    for (const std::string& motion : words_of(rows, "motion")) {
        const auto methods = words_of(rows_with(rows, "motion", motion), "method");
        charts.push_back({"realtime_" + motion, {{"motion", motion}, {"methods", in_words(methods)}}, {}, "realtime"});
    }
    return charts;
}

}  // namespace

Experiment realtime_experiment() {
    return {"realtime",
            "how large a cloth can be moved in real time, and how accurately?",
            5,
            {name_column<FrameMotion>("motion"), word_column("method", names_in(frame_methods(), &FrameMethod::name)),
             whole_column("threads", 1), whole_column("side", 2),
             number_column("wall_s_per_s").or_nan(),    // of a simulated second
             number_column("cpu_s_per_s").or_nan(),     // that of all threads
             number_column("stretch_excess").or_nan(),  // 99th percentile at the end, over the converged cloth's
             number_column("error").or_nan(),           // largest distance from that at any moment, of the side
             word_column("end", {"realtime", "late", "stretched", "diverged"})},
            {{"motion", "threads", "method", "end"}, {"side", "error", "stretch_excess", "wall_s_per_s"}},
            {{"", realtime_cases, realtime_charts}}};
}

}  // namespace drape
