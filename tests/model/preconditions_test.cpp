// What a caller must hold to is checked where assertions are on, as they are in the tests.

#include "drape/model/forces.h"
#include "drape/model/jacobian.h"
#include "support/expect_assertion.h"

namespace drape {
namespace {

ClothParameters sheet(int nx, int ny) {
    ClothParameters parameters;
    parameters.particles = {nx, ny};
    return parameters;
}

TEST(ModelDeathTest, RefusesAGridWithoutCells) {
    EXPECT_ASSERTION(static_cast<void>(make_cloth_model(sheet(1, 5))), "grid.nx >= 2");
}

TEST(ModelDeathTest, RefusesAClothWithoutMass) {
    ClothParameters parameters = sheet(4, 4);
    parameters.mass = 0;
    EXPECT_ASSERTION(static_cast<void>(make_cloth_model(parameters)), "mass > 0");
}

TEST(ModelDeathTest, RefusesAStretchLimitBelowZero) {
    ClothParameters parameters = sheet(4, 4);
    parameters.stretch_limit = Real(-0.1);
    EXPECT_ASSERTION(static_cast<void>(make_cloth_model(parameters)), "stretch_limit >= 0");
}

TEST(ModelDeathTest, RefusesAPinThatIsNoParticle) {
    ClothParameters parameters = sheet(4, 4);
    parameters.pinned = {Pins::Kind::List, {16}};
    EXPECT_ASSERTION(static_cast<void>(make_cloth_model(parameters)), "particle < grid.particles");
}

TEST(ModelDeathTest, RefusesForcesOfAnotherSize) {
    const ClothModel model = make_cloth_model(sheet(4, 4));
    const Points points = Points::Zero(16, 3);
    Points forces(15, 3);
    EXPECT_ASSERTION(compute_forces(model, points, points, forces), "f.rows");
}

TEST(ModelDeathTest, RefusesAJacobianOfAnotherGrid) {
    const ClothModel model = make_cloth_model(sheet(4, 4));
    const Points points = Points::Zero(16, 3);
    Jacobian jacobian(Grid{3, 4}, Hessian::Clamped, Kernels::Vector);
    EXPECT_ASSERTION(jacobian.linearise(model, points, points), "model.grid");
}

}  // namespace
}  // namespace drape
