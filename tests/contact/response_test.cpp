#include "drape/contact/response.h"

#include <gtest/gtest.h>

#include "drape/contact/detection.h"
#include "drape/integrate/integrator.h"

namespace drape {
namespace {

constexpr Real floor_radius = 1000;  // so large a ball is a floor for a small cloth
constexpr Real dt = 1e-4;

/// A stiff little cloth on a floor at y = 0.
struct Floor {
    ClothModel model;
    ClothState state;
    Points before;
    Surface surface{.friction = 0};
    std::vector<Ball> balls{{.centre = Vec3(0, -floor_radius, 0), .radius = floor_radius}};
    std::vector<ContactRow> contacts;
    std::vector<CellRange> cells;
    ContactSolver solver;
    Real deepest = 0;

    explicit Floor(Real height) {
        ClothParameters cloth;
        cloth.particles = {5, 5};
        cloth.width = cloth.height = 0.2;
        cloth.centred = true;
        cloth.place = {0, height, 0};
        cloth.drag = 0;
        model = make_cloth_model(cloth);
        state = make_rest_state(cloth);
        before = state.x;
        cells.assign(1, all_cells(model.grid));
    }

    void respond() {
        contacts.clear();
        find_contacts({model.grid, before, state.x}, balls[0], {}, cells, contacts, Kernels::Vector);
        balls[0].moved = dt * balls[0].velocity;
        const ClothInContact cloth{model, before, state};
        Body body = body_of(balls[0], surface);
        deepest = solver.resolve({}, dt, std::span(&cloth, 1), std::span(&body, 1), contacts).depth;
        balls[0] = body;
    }

    void run(Real time) {
        const auto integrator = make_integrator({.integrator = IntegratorKind::SymplecticEuler}, model.grid);
        for (int step = 0; step < time / dt; ++step) {
            before = state.x;
            integrator->step(model, state, dt);
            respond();
        }
    }

    [[nodiscard]] Vec3 mean_velocity() const { return state.v.colwise().mean().transpose(); }
};

/// Where a triangle hangs on pins so nearly that the free corner can hardly move the point, the ball moves alone.
TEST(Response, BesidePinsMovesAFreeBallAndNoParticleFar) {
    Floor floor(0);
    floor.model.inverse_mass[0] = floor.model.inverse_mass[1] = 0;
    const auto at = [&](int particle) { return Vec3(floor.state.x.row(particle).transpose()); };
    constexpr Real of_free_corner = Real(0.03), radius = Real(0.005), depth = Real(1e-3);
    const Vec3 point = (1 - of_free_corner) / 2 * (at(0) + at(1)) + of_free_corner * at(floor.model.grid.nx);
    floor.balls[0] = {.centre = point - Vec3(0, radius - depth, 0), .radius = radius, .inverse_mass = 1};
    const Vec3 centre = floor.balls[0].centre;
    floor.respond();
    EXPECT_EQ(floor.contacts.size(), 1u);
    EXPECT_NEAR(centre.y() - floor.balls[0].centre.y(), depth, depth / 10);
    EXPECT_LT((floor.state.x - floor.before).cwiseAbs().maxCoeff(), depth);
}

TEST(Response, TakesTrianglesOutOfTheBallVerticesAndInteriorsAlike) {
    // A ball smaller than a cell, in the middle of a triangle and far from every vertex
    Floor floor(0);
    floor.balls[0] = {.centre = Vec3(0.01, -0.015, 0.015), .radius = 0.02};
    floor.respond();
    ASSERT_FALSE(floor.contacts.empty());
    for (int t = 0; t < floor.model.grid.triangles(); ++t) {
        std::vector<ContactRow> left;
        const int columns = floor.model.grid.cell_columns();
        const int i = t / 2 % columns, j = t / 2 / columns;
        const CellRange cell{i, j, i + 1, j + 1};
        find_contacts({floor.model.grid, floor.before, floor.state.x}, floor.balls[0], {}, std::span(&cell, 1), left,
                      Kernels::Vector);
        for (const ContactRow& contact : left) EXPECT_LT(contact.depth, 1e-2 * 0.02);
    }
    EXPECT_LT(floor.deepest, 1e-3 * 0.02);
}

TEST(Friction, CarriesTheClothAlongWithTheBall) {
    Floor floor(0);
    floor.surface.friction = 1;
    floor.balls[0].velocity = {0.2, 0, 0};
    floor.run(0.1);
    EXPECT_NEAR(floor.mean_velocity()[0], 0.2, 0.01);
}

TEST(Response, SurvivesAClothThroughTheVeryCentre) {
    Floor floor(0);
    floor.balls[0] = {.centre = Vec3(0, 0, 0), .radius = 0.05};
    floor.respond();
    EXPECT_TRUE(floor.state.x.allFinite() && floor.state.v.allFinite());
}

}  // namespace
}  // namespace drape
