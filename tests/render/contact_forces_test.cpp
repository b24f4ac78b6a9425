#include "render/contact_forces.h"

#include <gtest/gtest.h>

#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

struct Sums {
    Vec3 force = Vec3::Zero();  ///< on the cloth, mean over the steps [N]
    Real sliding = 0, all = 0;  ///< their impulses [N s]
};

/// Of the steps of a tenth of a second from a time on.
Sums forces_after(double time, const std::string& scene, const std::vector<std::string>& changes) {
    Settings settings = load_scene(scene);
    assign_all(settings, changes);
    Simulation simulation(scene, std::move(settings));
    Sums sums;
    int steps = 0;
    while (simulation.report().time < time + 0.1) {
        simulation.step();
        if (simulation.report().time < time) continue;
        ++steps;
        const FrameView view = simulation.view(1);
        for (const ContactRow& row : view.cloths[0].contacts) {
            if (!row.has_impulse()) continue;
            const ContactForce force = force_of(view, row);
            sums.force += force.force;
            sums.sliding += force.hold == Hold::Slides ? row.impulse.normal : 0;
            sums.all += row.impulse.normal;
            EXPECT_LE(static_cast<double>(force.force.norm()), full_force(view));
        }
    }
    sums.force /= static_cast<Real>(steps);
    return sums;
}

TEST(ContactForces, CarryAClothThatRestsAndStick) {
    const Sums sums =
        forces_after(4, "drop", {"cloth.particles=14,14", "solver.sleep_speed=0", "solver.dt=5e-4", "friction=1"});
    const Real weight = load_scene("drop").cloths[0].mass * Real(9.81);
    EXPECT_NEAR(sums.force.y(), weight, 0.03 * weight);
    EXPECT_NEAR(sums.force.x(), 0, 0.03 * weight);
    EXPECT_LT(sums.sliding, 0.2 * sums.all);
}

TEST(ContactForces, SlideWhereFrictionIsWeak) {
    const Sums sums = forces_after(0.8, "slide", {});
    EXPECT_GT(sums.sliding, 0.8 * sums.all);
    EXPECT_GT(sums.all, 0);
}

}  // namespace
}  // namespace drape
