#include "drape/session/unstable_mode.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "drape/base/numbers.h"
#include "drape/model/jacobian.h"
#include "drape/model/stencils.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

/// A cloth without damping, whose step is set to 1.1 of its limit after some time, until it has diverged.
struct UnstableRun : testing::Test {
    UnstableRun()
        : session(small_simulation({"cloth.structural.damping=0", "cloth.shear.damping=0", "cloth.bend.damping=0"})) {
        session.keep_history({});
        make_steps(session, 600);
        limit = session.simulation().longest_step();
        session.send(parse_command("set solver.dt=" + real_text(1.1 * limit)));
        make_steps(session, 3000);
        EXPECT_EQ(session.simulation().report().status, Status::Diverged);
    }

    Session session;
    double limit = 0;  ///< [s]
};

TEST_F(UnstableRun, ShowsTheEigenvectorThatLimitsTheStep) {
    const FrameView view = session.view();
    ASSERT_NE(view.mode, nullptr);
    const UnstableMode& mode = *view.mode;
    EXPECT_NEAR(static_cast<double>(mode.limit.step), limit, 0.05 * limit);
    EXPECT_NEAR(mode.step, 1.1 * limit, 1e-9);
    EXPECT_LT(mode.time, view.report->time) << "before it diverged";
    const int a = mode.spring[0], b = mode.spring[1];
    bool is_there = false;
    for_each_spring_at(view.cloths[0].model, a, [&](const SpringStencil& springs, int other) {
        is_there = is_there || (other == b && springs.kind() == mode.kind);
    });
    EXPECT_TRUE(is_there);
    EXPECT_THAT(text_of(mode, true),
                testing::AllOf(testing::HasSubstr("the " + std::string(mode.kind) + " spring"),
                               testing::HasSubstr("at t = " + real_text(mode.time, 3) + " s"),
                               testing::HasSubstr("step was " + real_text(1e3 * mode.step, 3) + " ms")));

    EXPECT_THAT(text_of(mode, false), testing::Not(testing::HasSubstr("limit")));

    // M^-1 K y = omega^2 y, with omega of the predicted limit 2 / omega
    const ClothModel& model = view.cloths[0].model;
    Jacobian jacobian(model.grid, Hessian::Clamped, Kernels::Plain);
    jacobian.linearise(model, view.cloths[0].x, *view.cloths[0].v);
    Points pulled = Points::Zero(mode.shape.rows(), 3);
    jacobian.add_product(1, 0, mode.shape, pulled);
    for (int axis = 0; axis < 3; ++axis) pulled.col(axis).array() *= model.inverse_mass;
    const Real square = 4 / static_cast<Real>(limit * limit);
    EXPECT_LT((pulled - square * mode.shape).norm(), 0.05 * square * mode.shape.norm());
    for (const int corner : {0, 9}) EXPECT_TRUE(mode.shape.row(corner).isZero(0)) << "pinned";
}

/// A moment that is kept may be of a cloth that has been replaced since, before its first step.
TEST(UnstableMode, IsThatOfTheClothThatDiverged) {
    Session session(small_simulation());
    session.keep_history({});
    for (const char* command : {"scene hang", "set cloth.particles=12,12", "set solver.integrator=symplectic_euler",
                                "set solver.on_unstable=warn", "set solver.dt=0.02"}) {
        session.send(parse_command(command));
    }
    make_steps(session, 200);
    ASSERT_EQ(session.simulation().report().status, Status::Diverged);
    ASSERT_TRUE(session.swings());
    EXPECT_EQ(session.view().mode->shape.rows(), 12 * 12);
}

TEST(UnstableMode, IsNotShownBesideARunThatIsCompared) {
    Session session(small_simulation());
    session.keep_history({});
    for (const char* command : {"set solver.integrator=explicit_euler", "set solver.on_unstable=warn",
                                "set solver.dt=0.02", "compare solver.integrator=backward_euler"}) {
        session.send(parse_command(command));
    }
    make_steps(session, 200);
    ASSERT_EQ(session.simulation().report().status, Status::Diverged);
    EXPECT_NE(session.view().comparison, nullptr);
    EXPECT_EQ(session.view().mode, nullptr);
    session.send(parse_command("compare none"));
    EXPECT_NE(session.view().mode, nullptr);
}

TEST_F(UnstableRun, SwingsByAQuarterOfACellUntilItIsLeft) {
    const Points before = session.view().cloths[0].x;
    const std::uint64_t hash = session.simulation().hash();
    session.advance(0.25, 1e9);
    const FrameView view = session.view();
    const ClothModel& model = view.cloths[0].model;
    const Real farthest = (view.cloths[0].x - before).rowwise().norm().maxCoeff();
    EXPECT_NEAR(farthest, std::min(model.hx, model.hy) / 4, 1e-6) << "after a quarter of a second";
    EXPECT_EQ(session.simulation().hash(), hash);

    EXPECT_EQ(session.simulation().steps_wanted(), 0) << "those that it cannot make";
    session.send(command::Step{1'000'000});
    EXPECT_EQ(session.simulation().steps_wanted(), 0);
    session.send(command::Pause{});
    const std::int64_t end = session.timeline().newest;
    for (int k = 0; k < 100; ++k) session.advance(0.1, 0.01);
    EXPECT_EQ(session.timeline().newest, end) << "nothing else happens any more";
    go_to(session, end - 2);
    EXPECT_EQ(session.simulation().report().status, Status::Ok);
    EXPECT_EQ(session.timeline().now, end - 2);
    EXPECT_FALSE(session.swings());
    EXPECT_EQ(session.view().mode, nullptr);
    go_to(session, end);
    EXPECT_TRUE(session.swings());
    session.send(command::Reset{});
    EXPECT_EQ(session.view().mode, nullptr);
}

}  // namespace
}  // namespace drape
