// What a caller must hold to is checked where assertions are on, as they are in the tests.

#include "drape/model/forces.h"
#include "drape/model/jacobian.h"
#include "support/expect_assertion.h"

namespace drape {
namespace {

ClothModel model_with(void (*change)(ClothParameters&)) {
    ClothParameters parameters;
    parameters.particles = {4, 4};
    change(parameters);
    return make_cloth_model(parameters);
}

TEST(ModelDeathTest, RefusesParametersThatNoClothHas) {
    EXPECT_ASSERTION(model_with([](ClothParameters& cloth) { cloth.particles = {1, 5}; }), "grid.nx >= 2");
    EXPECT_ASSERTION(model_with([](ClothParameters& cloth) { cloth.mass = 0; }), "mass > 0");
    EXPECT_ASSERTION(model_with([](ClothParameters& cloth) { cloth.stretch_limit = Real(-0.1); }),
                     "stretch_limit >= 0");
    EXPECT_ASSERTION(model_with([](ClothParameters& cloth) {
                         cloth.pinned = {Pins::Kind::List, {16}};
                     }),
                     "particle < grid.particles");
}

TEST(ModelDeathTest, RefusesArraysOfAnotherSize) {
    const ClothModel model = model_with([](ClothParameters&) {});
    const Points points = Points::Zero(16, 3);
    Points forces(15, 3);
    EXPECT_ASSERTION(compute_forces(model, points, points, forces), "f.rows");
    Jacobian jacobian(Grid{3, 4}, Hessian::Clamped, Kernels::Vector);
    EXPECT_ASSERTION(jacobian.linearise(model, points, points), "model.grid");
}

}  // namespace
}  // namespace drape
