#include <algorithm>
#include <map>
#include <memory>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/model/stencils.h"
#include "drape/scene/scene.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "lab/needs/needs.h"

namespace drape {
namespace {

/// What a square cloth of 1 m does, of any number of particles: its mass, its drag and its springs stay the same.
struct FrameMotion {
    std::string name, scene;
};

constexpr double frame = 1.0 / 60;    // s
constexpr double most_excess = 0.01;  // of the stretch, that a picture may have

/// @param method and, behind "_by_", in how many steps it makes a frame
Settings settings_of(const FrameMotion& motion, const std::string& method, int side, int threads) {
    const bool folds = motion.name == "fold";
    const std::size_t by = method.rfind("_by_");
    Settings settings = with_method(load_scene(motion.scene), methods_named({method.substr(0, by)})[0].parameters);
    ClothParameters& cloth = settings.cloths[0];
    cloth.particles = {side, side};
    cloth.width = cloth.height = 1;
    cloth.mass = Real(0.2);
    cloth.structural = {800, Real(0.02)};
    cloth.shear = {200, Real(0.02)};
    cloth.bend = {5, Real(0.01)};
    cloth.drag = Real(0.7) / static_cast<Real>(cloth.particles.particles());
    cloth.stretch_limit = 0;  // what a method leaves of the springs is to be seen
    if (motion.name == "free") settings.balls.clear();
    if (folds) cloth.place += Vec3(Real(-0.1), Real(0.2), 0);  // the scene's sheet is smaller
    settings.contact.self = folds;
    settings.solver.threads = threads;
    settings.solver.dt = frame / parse_real(method.substr(by + 4)).value();
    settings.solver.on_unstable = OnUnstable::Substep;
    settings.solver.sleep_speed = 0;
    settings.needs.horizon = Real(0.5);
    // How a sheet buckles is a matter of chance
    settings.needs.measure = folds ? NeedsMeasure::CentreAndSpread : NeedsMeasure::Positions;
    return settings;
}

/// That all but a hundredth of the structural springs stay below at the end, of their length.
/// @param cloth of the motion, but for its particles
double stretch_of(ClothParameters cloth, const Motion& motion) {
    cloth.particles = motion.grid;
    const Points& x = motion.x.back();
    std::vector<Real> all;
    for (const SpringStencil& springs : spring_stencils(make_cloth_model(cloth))) {
        if (!springs.structural()) continue;
        springs.for_each(motion.grid,
                         [&](int a, int b) { all.push_back((x.row(a) - x.row(b)).norm() / springs.rest_length - 1); });
    }
    const auto high = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 99 / 100);
    std::ranges::nth_element(all, high);
    return static_cast<double>(*high);
}

/// The finest grid that can be waited for, by a method of second order at nine tenths of its limit.
Motion converged(const FrameMotion& motion, bool quick) {
    Motion run = run_to_horizon(settings_of(motion, "velocity_verlet_by_1", quick ? 45 : 181, 1));
    if (run.diverged) throw RunError("realtime: the reference of '" + motion.name + "' has diverged");
    return run;
}

/// A cloth of one size by one method.
Row run_one(const FrameMotion& motion, const std::string& method, int side, int threads, const Motion& truth) {
    constexpr double patience = 4;  // s/s
    const Settings settings = settings_of(motion, method, side, threads);
    const Motion run = run_to_horizon(settings, patience * threads);
    Row row{{"side", side}, {"end", run.diverged ? "diverged" : "late"}};
    if (run.diverged || run.given_up) return row;
    const ClothParameters& cloth = settings.cloths[0];
    const double excess = std::max(stretch_of(cloth, run) - stretch_of(cloth, truth), 0.0);
    row.set({{"wall_s_per_s", run.wall},
             {"cpu_s_per_s", run.cost},
             {"stretch_excess", excess},
             {"error", motion_error(run, truth, settings.needs.measure, 1)}});
    if (run.wall <= 1) row.set("end", excess <= most_excess ? "realtime" : "stretched");
    return row;
}

ExperimentCases realtime_cases(bool quick) {
    const auto truths = std::make_shared<std::map<std::string, Motion>>();  // found when the first case asks for them
    const auto run = [=](const FrameMotion& motion, int threads, const std::string& method) {
        if (!truths->contains(motion.name)) truths->emplace(motion.name, converged(motion, quick));
        // From small to large, until it is no longer real time
        Rows rows;
        for (const int side : {16, 23, 32, 45, 64, 91, 128, 181, 256}) {
            if (quick && side > 32) break;
            rows.push_back(run_one(motion, method, side, threads, truths->at(motion.name)));
            if (rows.back().word("end") == "late") break;
        }
        return rows;
    };
    const std::vector<FrameMotion> motions{{"free", "two_corners"},  // falls, hung by two corners
                                           {"ball", "drop"},         // falls flat on a ball
                                           {"fold", "fold"}};        // falls upright on the ground and folds on itself
    // One with a step limit makes one step a frame, which is divided as its limit asks for
    const Axis<std::string> methods{
        "method",
        {"symplectic_euler_by_1", "velocity_verlet_by_1", "rk4_by_1", "backward_euler_clamped_by_1",
         "backward_euler_clamped_by_2", "backward_euler_clamped_by_4", "bdf2_clamped_by_1", "bdf2_clamped_by_2",
         "bdf2_clamped_by_4", "xpbd_1_by_5", "xpbd_1_by_10", "xpbd_1_by_20", "xpbd_1_by_40", "xpbd_20_by_1",
         "projective_dynamics_10_by_1"}};
    return cases_over(run, Axis<FrameMotion>{"motion", motions}, Axis<int>{"threads", {1, 2}}, methods)(quick);
}

}  // namespace

Experiment realtime_experiment() {
    return {"realtime",
            "how large a cloth can be moved in real time, and how accurately?",
            5,
            {"motion", "method", "threads", "side",
             "wall_s_per_s",    // of a simulated second
             "cpu_s_per_s",     // that of all threads
             "stretch_excess",  // 99th percentile at the end, over the converged cloth's
             "error",           // largest distance from that at any moment, of the side
             "end"},
            {{"", realtime_cases, {{"realtime"}}, "motion"}}};
}

}  // namespace drape
