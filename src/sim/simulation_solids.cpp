#include <algorithm>
#include <utility>

#include "drape/sim/simulation.h"
#include "solid_motion.h"

namespace drape {

void Simulation::move_solids(const Substep& now) {
    for (std::size_t s = 0; s < solids_.size(); ++s) {
        move_solid(settings_.solids[s], static_cast<Real>(now.time), now.h, solids_[s]);
    }
}

/// Nothing that touched a solid where it was does so where it is now.
void Simulation::configure_solids(const Settings& before, std::vector<Solid> solids) {
    if (settings_.solids == before.solids) return;
    solids_ = std::move(solids);
    put_solids(settings_.solids, report_.time, solids_);
    previous_solids_ = solids_;
    contact_.forget_bodies([&](int body) { return body >= static_cast<int>(balls_.size()); });
}

}  // namespace drape
