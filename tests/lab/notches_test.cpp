#include "lab/needs/needs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drape/base/input_error.h"
#include "drape/model/energy.h"
#include "drape/sim/simulation.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

Settings scene_with_everything() {
    Settings scene;
    scene.cloths[0].particles = {31, 21};
    scene.solver.integrator = IntegratorKind::Xpbd;
    scene.solver.iterations = 2;
    scene.solver.dt = Real(2e-4);
    scene.balls.emplace_back();
    return scene;
}

TEST(Notches, AreFourFifthsOfTheCellsWithTheSameDragOnTheWhole) {
    const Settings scene = scene_with_everything();
    const ClothParameters cloth = scene.cloths[0], less = one_notch_less(scene, Knob::Particles)->cloths[0];
    EXPECT_EQ(less.particles, (Grid{25, 17}));
    EXPECT_EQ(less.mass, cloth.mass);
    EXPECT_NEAR(less.drag * 25 * 17, cloth.drag * 31 * 21, 1e-6);
    EXPECT_EQ(less.structural, cloth.structural);
    EXPECT_FALSE(one_notch_less(on_grid(scene, {5, 5}), Knob::Particles));
}

TEST(Notches, TakeAwayBendSpringsDragAndIterationsAndLengthenTheStep) {
    const Settings scene = scene_with_everything();
    EXPECT_EQ(one_notch_less(scene, Knob::Bend)->cloths[0].bend, SpringLaw{});
    EXPECT_EQ(one_notch_less(scene, Knob::Drag)->cloths[0].drag, 0);
    EXPECT_EQ(one_notch_less(scene, Knob::Iterations)->solver.iterations, 1);
    EXPECT_EQ(one_notch_less(scene, Knob::Dt)->solver.dt, Real(2.5e-4));
    for (const Knob knob : {Knob::Bend, Knob::Drag, Knob::Iterations}) {
        EXPECT_FALSE(one_notch_less(*one_notch_less(scene, knob), knob)) << name_of(knob);
    }
    EXPECT_FALSE(one_notch_less(scene, Knob::Volume));
}

TEST(FreeKnobs, AreAllButThoseThatTheSceneKeepsOrThatHaveNothingToActOn) {
    Settings scene = scene_with_everything();
    EXPECT_EQ(free_knobs(scene).size(), names_of<Knob>().size());
    scene.needs.keep = "particles,  dt";
    const auto knobs = free_knobs(scene);
    EXPECT_EQ(knobs.size(), names_of<Knob>().size() - 2);
    EXPECT_FALSE(knobs.contains(Knob::Particles) || knobs.contains(Knob::Dt));
    scene.needs.keep.clear();
    scene.balls.clear();
    scene.cloths[0].pinned = {Pins::Kind::List, {3}};
    for (const Knob knob : {Knob::Volume, Knob::LeafCells, Knob::Particles}) {
        EXPECT_FALSE(free_knobs(scene).contains(knob)) << "nothing to act on";
    }
}

TEST(FullModel, HasWhatTheNeedsSayAndTheRestOfTheScene) {
    Settings scene = scene_with_everything();
    EXPECT_EQ(full_model(scene).cloths, scene.cloths);
    scene.cloths[0].bend = {};
    scene.needs.full = {{40, 30}, {7, Real(0.5)}, 0};
    const ClothParameters cloth = full_model(scene).cloths[0];
    EXPECT_EQ(cloth.particles, (Grid{40, 30}));
    EXPECT_EQ(cloth.bend, (SpringLaw{7, Real(0.5)}));
    EXPECT_NEAR(cloth.drag * 40 * 30, scene.cloths[0].drag * 31 * 21, 1e-6);
    scene.needs.full.particles = {0, 30};
    EXPECT_THROW(full_model(scene), InputError);
}

/// A cloth that is bent like u^2 + 3 u w over the parts u and w of its sides.
Points bent(const Grid& grid, Real curvature) {
    Points x(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) {
        const Real u = static_cast<Real>(p % grid.nx) / static_cast<Real>(grid.nx - 1);
        const Real w = static_cast<Real>(p / grid.nx) / static_cast<Real>(grid.ny - 1);
        x.row(p) = Vec3(u, curvature * u * u + 3 * u * w, 2 * w).transpose();
    }
    return x;
}

TEST(Resampled, LiesOnTheOtherGridsCloth) {
    const Grid fine{41, 31}, coarse{9, 7};
    EXPECT_NEAR(static_cast<double>((resampled(bent(fine, 0), fine, coarse) - bent(coarse, 0)).norm()), 0, 1e-5);
    // Between particles the cloth is straight: off a parabola by at most h^2 / 4
    const Points off = resampled(bent(fine, 1), fine, coarse) - bent(coarse, 1);
    EXPECT_LE(static_cast<double>(off.cwiseAbs().maxCoeff()), 1.0 / 40 / 40 / 4 + 1e-5);
    EXPECT_EQ(resampled(bent(fine, 1), fine, fine), bent(fine, 1));
}

Motion motion_of(const Grid& grid, const Points& x) {
    Motion motion;
    motion.grid = grid;
    motion.x.assign(Motion::moments, x);
    return motion;
}

TEST(MotionError, OfAClothThatIsMovedOrWiderIsThatOverItsSide) {
    const Grid grid{9, 7};
    const Motion full = motion_of({17, 13}, bent({17, 13}, 0));
    Points moved = bent(grid, 0), wider = moved;
    moved.col(2).array() += Real(0.1);
    for (const auto measure : {NeedsMeasure::Positions, NeedsMeasure::CentreAndSpread}) {
        EXPECT_NEAR(motion_error(motion_of(grid, moved), full, measure, 2), 0.05, 1e-5);
    }
    wider *= Real(1.1);
    wider.rowwise() += (bent(grid, 0).colwise().mean() - wider.colwise().mean()).eval();
    const double spread = std::sqrt(
        static_cast<double>((bent(grid, 0).rowwise() - bent(grid, 0).colwise().mean()).squaredNorm()) / (9 * 7));
    EXPECT_NEAR(motion_error(motion_of(grid, wider), full, NeedsMeasure::CentreAndSpread, 1), 0.1 * spread, 1e-5);
    // One bad moment is enough
    Motion once = motion_of(grid, bent(grid, 0));
    EXPECT_NEAR(motion_error(once, full, NeedsMeasure::Positions, 1), 0, 1e-5);
    once.x[5] = moved;
    EXPECT_NEAR(motion_error(once, full, NeedsMeasure::Positions, 1), 0.1, 1e-5);
    once.x[5](3, 1) = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_TRUE(std::isnan(motion_error(once, full, NeedsMeasure::CentreAndSpread, 1)));
}

TEST(RunToHorizon, MeasuresTheStretchAfterEveryStep) {
    Settings scene = scene_with_everything();
    scene.balls.clear();
    scene.cloths[0].particles = {5, 5};
    scene.cloths[0].pinned.kind = Pins::Kind::Two;
    scene.solver.integrator = IntegratorKind::SymplecticEuler;
    scene.solver.dt = Real(1e-3);
    scene.needs.horizon = Real(0.32);
    Simulation simulation("", scene);
    double largest = 0, at_moments = 0;
    for (int step = 1; step <= 320; ++step) {
        simulation.step();
        const Cloth& cloth = simulation.cloths()[0];
        largest = std::max(largest, static_cast<double>(largest_stretch(cloth.model, cloth.state.x)));
        if (step % 20 == 0) {
            at_moments = std::max(at_moments, static_cast<double>(largest_stretch(cloth.model, cloth.state.x)));
        }
    }
    ASSERT_LT(at_moments, largest) << "the scene can tell the two apart";
    EXPECT_EQ(run_to_horizon(scene).stretch, largest);
}

TEST(RunToHorizon, KnowsAFreeFallBetweenStepsThatFitNoMoment) {
    Settings scene = scene_with_everything();
    scene.balls.clear();
    scene.ground.solid = false;
    scene.cloths[0].particles = {3, 3};
    scene.cloths[0].drag = 0;
    scene.solver.integrator = IntegratorKind::VelocityVerlet;
    scene.solver.dt = Real(0.0107);
    scene.needs.horizon = Real(0.5);
    scene.cloths[0].structural = scene.cloths[0].shear = scene.cloths[0].bend = {1, 0};
    const Motion motion = run_to_horizon(scene);
    ASSERT_EQ(motion.x.size(), Motion::moments);
    for (std::size_t k = 0; k < Motion::moments; ++k) {
        const double t = 0.5 * static_cast<double>(k + 1) / Motion::moments;
        EXPECT_NEAR(motion.x[k](4, 1), -9.81 * t * t / 2, sizeof(Real) == 8 ? 1e-9 : 1e-5);
    }
    EXPECT_GT(motion.cost, 0);
}

}  // namespace
}  // namespace drape
