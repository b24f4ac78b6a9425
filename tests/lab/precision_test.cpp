#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "lab/lab_run.h"
#include "lab/measure/methods.h"
#include "lab/precision/precision.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

TEST(StateError, IsTheRmsDistanceOfTheParticles) {
    Points one_off = Points::Zero(9, 3);
    one_off(2, 1) = Real(0.4);
    EXPECT_NEAR(position_error(one_off, Points::Zero(9, 3)), 0.4 / 3, 1e-8);
}

/// The small soft sheet of the quick run.
const PrecisionScene& soft() {
    static const PrecisionScene scene = precision_scenes(true).front();
    return scene;
}

/// The scene with a reference of Dormand-Prince to a tolerance, after one of ten times that.
PrecisionScene with_reference(PrecisionScene scene, Real tolerance) {
    const Rung before = solved_closely(10 * tolerance);
    scene.reference = {before, before, solved_closely(tolerance)};
    return scene;
}

TEST(Reference, TellsItsOwnError) {
    const Reference fine = find_reference(soft());
    for (const Real tolerance : {Real(1e-5), Real(1e-7)}) {
        const Reference coarse = find_reference(with_reference(soft(), tolerance));
        const double truth = position_error(coarse.state.x, fine.state.x);
        EXPECT_GT(truth, 10 * fine.error);
        EXPECT_GE(coarse.error, truth);
        EXPECT_LT(coarse.error, 100 * truth);
    }
    EXPECT_LT(fine.growth, 1) << "damping wins";
}

TEST(Reference, TellsThatSmallErrorsGrowOnTheWayToALateHorizon) {
    PrecisionScene scene = soft();
    ClothParameters& cloth = scene.settings.cloths.front();
    cloth.particles = {8, 8};
    for (SpringLaw* law : {&cloth.structural, &cloth.shear, &cloth.bend}) law->stiffness *= 10, law->damping /= 10;
    cloth.drag = Real(3e-4);
    const auto growth_to = [&scene](Real horizon) {
        scene.horizon = horizon;
        return find_reference(with_reference(scene, Real(1e-7))).growth;
    };
    EXPECT_LT(growth_to(Real(0.2)), most_growth);
    EXPECT_GT(growth_to(Real(1.6)), most_growth);
}

/// The order that a scene shows under a method from few steps to many, errors averaged as the experiment does.
double order_on(const PrecisionScene& scene, const Reference& reference, const IntegratorParameters& method,
                const std::array<int, 2>& counts) {
    std::vector<double> errors;
    for (const int count : counts) {
        double squares = 0;
        for (int phase = 0; phase < scene.phases; ++phase) {
            const Real within = scene.has_ball() ? (Real(phase) + Real(0.5)) / Real(scene.phases) : 0;
            const Finish end = finish(scene, {method, count}, within);
            EXPECT_TRUE(end.bounded);
            squares += std::pow(position_error(end.state.x, reference.state.x), 2);
        }
        errors.push_back(std::sqrt(squares / scene.phases));
    }
    return std::log(errors[0] / errors[1]) / std::log(static_cast<double>(counts[1]) / counts[0]);
}

TEST(Precision, FindsTheOrderOfAMethod) {
    const Reference reference = find_reference(soft());
    const std::array counts{128, 512};
    using enum IntegratorKind;
    EXPECT_NEAR(order_on(soft(), reference, {.integrator = SymplecticEuler}, counts), 1, 0.1);
    EXPECT_NEAR(order_on(soft(), reference, {.integrator = VelocityVerlet}, counts), 2, 0.1);
    EXPECT_NEAR(order_on(soft(), reference, {.integrator = Rk4}, counts), 4, 0.15);
    EXPECT_NEAR(order_on(soft(), reference, {.integrator = ImplicitMidpoint, .hessian = Hessian::Exact}, counts), 2,
                0.2);
    EXPECT_NEAR(order_on(soft(), reference, {.integrator = ImplicitMidpoint, .hessian = Hessian::Clamped}, counts), 2,
                0.2);
}

TEST(Precision, ContactMakesRk4AMethodOfFirstOrder) {
    PrecisionScene scene = precision_scenes(true).back();
    ASSERT_TRUE(scene.has_ball());
    for (Rung& rung : scene.reference) rung.steps /= 1 << 5;
    const std::array counts{64, 256};
    const IntegratorParameters rk4{.integrator = IntegratorKind::Rk4};
    const double touched = order_on(scene, find_reference(scene), rk4, counts);
    EXPECT_NEAR(touched, 1, 0.3);
    scene.horizon = Real(0.19);  // just before the impact, where errors are those of rounding
    const Reference before = find_reference(scene);
    const Finish end = finish(scene, {rk4, 64}, Real(0.5));
    EXPECT_LT(position_error(end.state.x, before.state.x), 1e-8);
}

TEST(LabPrecision, WritesARowAStepAndTellsTheOrderAndWhatTheReferenceIsWorth) {
    const LabFolder folder;
    const LabRun run = folder.run({"precision", "--quick", "--cases", "3-3", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = table_of(folder, "out/precision.csv");
    ASSERT_GT(rows.size(), 4u);
    EXPECT_THAT(rows[0], AllOf(HasSubstr("measure,error,"), HasSubstr(",reference_error,growth")));
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/precision_soft.svg"), HasSubstr(">velocity Verlet, order 2<"));
    EXPECT_THAT(
        folder.read("out/precision.html"),
        ContainsRegex("The reference is in error by [0-9.e-]+; a small error at the start grows [0-9.e-]+ times"));
}

}  // namespace
}  // namespace drape
