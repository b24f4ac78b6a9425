#include <algorithm>
#include <utility>

#include "drape/contact/ball_solids.h"
#include "drape/sim/simulation.h"
#include "solid_motion.h"

namespace drape {

void Simulation::move_solids(const Substep& now) {
    for (std::size_t s = 0; s < solids_.size(); ++s) {
        move_solid(settings_.solids[s], static_cast<Real>(now.time), now.h, solids_[s]);
    }
}

/// The keys lead a ball onto solids, as onto the ground.
void Simulation::stop_balls(const Substep& now) {
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        if (settings_.balls[b].motion != BallMotion::Keys) continue;
        stay_outside(solids_, 2 * settings_.contact.thickness, now.h, balls_[b]);
    }
}

void Simulation::meet_solids(Cloth& cloth) {
    report_.solids +=
        cloth.search.meet_solids(start_of_substep(cloth), cloth.state.x, solids_, settings_.contact, cloth.contacts);
}

/// Nothing that touched a solid where it was does so where it is now.
void Simulation::configure_solids(const Settings& before, std::vector<Solid> solids) {
    if (settings_.solids == before.solids) return;
    solids_ = std::move(solids);
    put_solids(settings_.solids, report_.time, solids_);
    previous_solids_ = solids_;
    for (Cloth& cloth : cloths_) {
        std::erase_if(cloth.contacts, [](const Contact& contact) { return is_solid(contact.ball); });
    }
}

}  // namespace drape
