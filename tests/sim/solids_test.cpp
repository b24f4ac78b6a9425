// Cloth on boxes, capsules and meshes, in whole scenes.

#include <gmock/gmock.h>

#include "drape/session/failure.h"
#include "sim/small_scene.h"
#include "support/input_errors.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::HasSubstr;

/// The deepest point of any triangle in any solid, below the cloth's thickness, by a grid of points of each.
Real deepest(const Simulation& simulation) {
    constexpr int steps = 12;
    Real depth = 0;
    const Cloth& cloth = simulation.cloths()[0];
    for (int t = 0; t < cloth.model.grid.triangles(); ++t) {
        const auto corners = cloth.model.grid.triangle_corners(t);
        const auto at = [&](std::size_t k) { return Vec3(cloth.state.x.row(corners[k]).transpose()); };
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; i + j <= steps; ++j) {
                const Vec3 p = at(0) + Real(i) / steps * (at(1) - at(0)) + Real(j) / steps * (at(2) - at(0));
                for (const Solid& solid : simulation.solids()) {
                    depth = std::max(depth, simulation.settings().contact.thickness - solid.distance(p));
                }
            }
        }
    }
    return depth;
}

Settings small(const std::string& scene, int particles) {
    Settings settings = load_scene(scene);
    ClothParameters& cloth = settings.cloths[0];
    cloth.drag *= static_cast<Real>(cloth.particles.particles()) / static_cast<Real>(particles * particles);
    cloth.particles = {particles, particles};
    return settings;
}

TEST(LongSolids, ATableclothFallsAsleep) {
    Simulation simulation("table", small("table", 8));
    while (!simulation.report().asleep && simulation.report().time < 20) simulation.step();
    EXPECT_TRUE(simulation.report().asleep);
    EXPECT_GT(simulation.report().contacts, 3);
    EXPECT_LT(deepest(simulation), 5e-5);
}

TEST(Solids, EachResponseAndMethodKeepsClothOutOfThem) {
    for (const ResponseKind response : values_of<ResponseKind>()) {
        for (const auto integrator : {IntegratorKind::SymplecticEuler, IntegratorKind::BackwardEuler}) {
            Settings settings = small("table", 10);
            settings.contact.response = response;
            settings.solver.integrator = integrator;
            Simulation simulation("table", settings);
            run_until(simulation, 0.5);
            EXPECT_GT(simulation.report().contacts, 3);
            EXPECT_LT(deepest(simulation), 0.002) << name_of(response) << ", " << name_of(integrator);
        }
    }
}

TEST(LongSolids, NothingOfAClothThatRestsOnAMeshIsDeeperThanTheSlop) {
    Simulation simulation("figure", small("figure", 10));
    run_until(simulation, 0.4);
    EXPECT_GT(simulation.report().contacts, 3);
    EXPECT_LT(deepest(simulation), 2e-4);  // a mesh is not convex: what is lowest nearby is found
}

/// A plate as thin as a hair, as fast as a bullet.
TEST(Solids, AFastThinPlateTakesTheClothAlong) {
    for (const auto continuous : {Continuous::Auto, Continuous::Never}) {
        Settings settings = small("table", 8);
        settings.solver.dt = 1e-3;
        settings.ground.solid = false;
        settings.contact.continuous = continuous;
        settings.cloths[0].structural.damping = settings.cloths[0].shear.damping = Real(0.02);
        SolidSettings& plate = settings.solids[0];
        plate.size = {2, Real(1e-4), 2};
        plate.angle = 0;
        plate.motion = SolidMotion::Path;
        plate.path = {{0, Vec3(0, 0.3, 0)}, {Real(0.02), Vec3(0, 1.3, 0)}};
        Simulation simulation("plate", settings);
        run_until(simulation, 0.02);
        const bool above = simulation.cloths()[0].state.x.col(1).minCoeff() > simulation.solids()[0].position.y();
        EXPECT_EQ(above, continuous == Continuous::Auto);
    }
}

/// A small cloth on a box, with nothing below it for a while.
Settings cloth_on_a_box(IntegratorKind integrator) {
    Settings settings = small("table", 8);
    ClothParameters& cloth = settings.cloths[0];
    cloth.width = cloth.height = Real(0.3);
    cloth.mass = Real(0.05);
    cloth.drag = 0;
    settings.solver.integrator = integrator;
    settings.ground.height = -5;
    return settings;
}

class SolidsLeft : public testing::TestWithParam<IntegratorKind> {};

constexpr IntegratorKind one_of_each_sort[] = {IntegratorKind::VelocityVerlet, IntegratorKind::BackwardEuler};
constexpr IntegratorKind other_methods[] = {IntegratorKind::Rk4, IntegratorKind::SymplecticEuler, IntegratorKind::Bdf2};
INSTANTIATE_TEST_SUITE_P(EachSort, SolidsLeft, testing::ValuesIn(one_of_each_sort), name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, SolidsLeft, testing::ValuesIn(other_methods), name_of_param);

/// The plane of a contact goes on where the solid ends.
TEST_P(SolidsLeft, HoldTheClothNoMore) {
    for (const bool slides : {true, false}) {
        Settings settings = cloth_on_a_box(GetParam());
        SolidSettings& box = settings.solids[0];
        settings.contact.friction = slides ? Real(0) : Real(0.3);
        if (slides) {
            box.axis = {0, 0, 1};
            box.angle = 20;
        } else {
            box.angle = 0;
            box.motion = SolidMotion::Path;
            box.path = {{0, box.position}, {Real(0.5), box.position}, {Real(0.7), box.position - Vec3(0, 3, 0)}};
        }
        Simulation simulation("table", std::move(settings));
        SCOPED_TRACE(slides ? "slides off" : "the box drops away");
        std::int64_t most = 0;
        run_until(simulation, 0.5, [&] { most = std::max(most, simulation.report().contacts); });
        run_until(simulation, 2);
        EXPECT_GT(most, 3);
        const Cloth& cloth = simulation.cloths()[0];
        EXPECT_LT(cloth.state.x.col(1).minCoeff(), slides ? -4 : -2) << "on the ground, or on the box again";
        const int first_solid = static_cast<int>(simulation.balls().size());
        for (const ContactRow& row : simulation.contacts()) EXPECT_FALSE(slides && row.body == first_solid);
    }
}

TEST(Solids, APathCarriesThemAndSettingsAreChangedInMidRun) {
    Settings settings = small("table", 6);
    settings.solids[0].motion = SolidMotion::Path;
    settings.solids[0].path = {{0, Vec3(0, 0.2, 0)}, {Real(0.1), Vec3(0.3, 0.2, 0)}};
    Simulation moved("table", settings);
    run_until(moved, 0.2);
    EXPECT_NEAR(moved.solids()[0].position.x(), 0.3, 1e-9);
    send(moved, "reset");
    EXPECT_NEAR(moved.solids()[0].position.x(), 0, 1e-9);
    Simulation simulation("table", small("table", 6));
    run_until(simulation, 0.1);
    simulation.apply(command::Set{"solid.position=0,0.1,0"});
    EXPECT_EQ(simulation.solids()[0].position.y(), Real(0.1));
    EXPECT_THAT(input_error_of([&] { simulation.apply(command::Set{"solid.shape=mesh"}); }),
                HasSubstr("allowed only with a solid.file"));
    EXPECT_EQ(simulation.settings().solids[0].shape, SolidKind::Box);
}

TEST(Solids, TheSceneOfAFailureHasItsMeshBesideIt) {
    Settings settings = small("figure", 6);
    settings.solver.dt = 0.05;
    settings.solver.integrator = IntegratorKind::ExplicitEuler;
    Simulation simulation("figure", settings);
    while (simulation.report().status == Status::Ok && simulation.report().step < 10000) simulation.step();
    ASSERT_EQ(simulation.report().status, Status::Diverged);
    const ScratchFolder folder;
    const Settings read = load_scene(write_failure(simulation, folder.path()).string());
    EXPECT_EQ(Simulation("unstable", read).solids().size(), 1u);
}

TEST(Solids, BadSettingsAreNamedWithTheirLine) {
    const auto error_of = [](const std::string& lines) {
        return input_error_of([&] { parse_scene("[cloth]\n[[solid]]\n" + lines, "mine.toml"); });
    };
    EXPECT_THAT(error_of("shape = \"cone\""),
                HasSubstr("mine.toml:3:9: solid.shape = 'cone': allowed 'box', 'capsule' or 'mesh'"));
    EXPECT_THAT(error_of("size = [1, 0, 1]"),
                HasSubstr("mine.toml:3:8: solid.size = [1, 0, 1]: allowed three numbers"));
    EXPECT_THAT(error_of("axis = [0, 0, 0]"),
                HasSubstr("mine.toml:3:8: solid.axis = [0, 0, 0]: allowed a length of at least 1e-06"));
    EXPECT_THAT(error_of("motion = \"path\""),
                HasSubstr("mine.toml:3:10: solid.motion = path: allowed only with a solid.path"));
    EXPECT_THAT(error_of("shape = \"mesh\""),
                HasSubstr("mine.toml:3:9: solid.shape = mesh: allowed only with a solid.file"));
    EXPECT_THAT(error_of("colour = 1"), HasSubstr("unknown key 'solid.colour'"));
}

}  // namespace
}  // namespace drape
