#include "recorded_motion.h"

#include <algorithm>
#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "lab/measure/resampled.h"

namespace drape {
RecordedMotion record_motion(const MotionWanted& wanted) { return record_motion(wanted, load_scene(wanted.scene)); }

RecordedMotion record_motion(const MotionWanted& wanted, Settings settings) {
    settings.solver.sleep_speed = 0;
    settings.solver.ledger = false;
    const double dt = settings.solver.dt;
    const Real h = static_cast<Real>(dt), thickness = settings.contact.thickness;
    Simulation simulation(wanted.scene, settings);
    DRAPE_ASSERT(!simulation.balls().empty());
    const Cloth& cloth = simulation.cloths()[0];
    const Grid grid = cloth.model.grid;
    const auto integrator = make_integrator(integrator_of(settings.solver), grid);

    const int steps_between = std::max(static_cast<int>(std::lround(wanted.interval / dt)), 1);
    RecordedMotion motion{.scene = wanted.scene, .grid = grid, .interval = steps_between * dt, .x = {}, .balls = {}};
    const auto first = static_cast<std::int64_t>(std::llround(wanted.from / dt));
    const std::int64_t last = first + static_cast<std::int64_t>(wanted.frames - 1) * steps_between;
    for (std::int64_t step = 0; step <= last; ++step) {
        const bool kept = step >= first && (step - first) % steps_between == 0;
        if (kept) {
            ClothState next = cloth.state;
            integrator->step(cloth.model, next, h);
            motion.x.push_back(std::move(next.x));
        }
        simulation.step();
        if (kept) motion.balls.push_back(grown(simulation.balls()[0], thickness));
    }
    if (simulation.report().status != Status::Ok) throw RunError(wanted.scene + ": " + simulation.report().trouble);
    return motion;
}

RecordedMotion resampled(const RecordedMotion& motion, const Grid& grid) {
    RecordedMotion finer{
        .scene = motion.scene, .grid = grid, .interval = motion.interval, .x = {}, .balls = motion.balls};
    for (const Points& x : motion.x) finer.x.push_back(resampled(x, motion.grid, grid));
    return finer;
}

const RecordedMotion& Motions::find(const MotionWanted& wanted) {
    const auto key = std::tuple(wanted.scene, wanted.from, wanted.interval, wanted.frames);
    const auto found = recorded_.find(key);
    return found != recorded_.end() ? found->second : recorded_.emplace(key, record_motion(wanted)).first->second;
}

}  // namespace drape
