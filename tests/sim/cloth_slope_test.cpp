// Friction of cloth on cloth: a free sheet on a pinned, tilted one sticks, or slides as far as the formula says.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <optional>

#include "drape/integrate/stability.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr Real between_sheets = Real(0.004), spacing = Real(0.05);

/// Two sheets on a slope, the upper one by the thickness of cloth above the lower.
class SheetOnSlope {
public:
    SheetOnSlope(IntegratorKind integrator, double tangent, Real friction)
        : down_(Vec3(1, static_cast<Real>(-tangent), 0).normalized()) {
        Settings settings;
        settings.balls.clear();
        settings.cloths.clear();
        StartState start;
        for (const Grid& grid : {Grid{27, 11}, Grid{9, 9}}) {
            const auto number = static_cast<Real>(settings.cloths.size());
            ClothParameters& cloth = settings.cloths.emplace_back();
            cloth.particles = grid;
            cloth.width = spacing * static_cast<Real>(grid.nx - 1);
            cloth.height = spacing * static_cast<Real>(grid.ny - 1);
            cloth.mass = Real(0.05);
            cloth.drag = 0;
            ClothState& state = start.states.emplace_back(make_rest_state(cloth));
            for (int p = 0; p < grid.particles(); ++p) {
                // The upper sheet's particles are above no edge and no particle of the lower one
                const Real along = spacing * (static_cast<Real>(p % grid.nx) + Real(1.37) * number);
                const Real across = spacing * (static_cast<Real>(p / grid.nx) + Real(0.8) * number);
                const Vec3 up(-down_.y(), down_.x(), 0);
                state.x.row(p) = along * down_ + between_sheets * number * up + across * Vec3::UnitZ();
            }
        }
        Pins& pins = settings.cloths[0].pinned;
        pins.kind = Pins::Kind::List;
        pins.list.resize(static_cast<std::size_t>(settings.cloths[0].particles.particles()));
        std::iota(pins.list.begin(), pins.list.end(), 0);
        settings.contact.self = true;
        settings.contact.thickness = between_sheets;
        settings.contact.friction = friction;
        settings.ground.solid = false;
        settings.solver.integrator = integrator;
        const double short_step = integrator == IntegratorKind::VelocityVerlet ? 1e-4 : 5e-4;
        settings.solver.dt = has_step_limit(integrator) ? short_step : 1.0 / 60;
        settings.solver.sleep_speed = 0;
        simulation_.emplace("slope", std::move(settings), std::move(start));
    }

    void run_until(double time) { drape::run_until(*simulation_, time); }
    [[nodiscard]] double time() const { return simulation_->report().time; }

    /// Down the slope, of the mean of the upper sheet [m].
    [[nodiscard]] double way() const {
        return static_cast<double>(simulation_->cloths()[1].state.x.colwise().mean().transpose().dot(down_));
    }

private:
    Vec3 down_;
    std::optional<Simulation> simulation_;
};

class ClothOnClothSlope : public testing::TestWithParam<IntegratorKind> {};

INSTANTIATE_TEST_SUITE_P(Long, ClothOnClothSlope, testing::Values(IntegratorKind::SymplecticEuler), name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, ClothOnClothSlope,
                         testing::ValuesIn(methods_but({IntegratorKind::ExplicitEuler, IntegratorKind::Rk4})),
                         name_of_param);

TEST_P(ClothOnClothSlope, SticksBelowTheAngleOfFriction) {
    SheetOnSlope sheet(GetParam(), 0.98 * 0.3, Real(0.3));
    sheet.run_until(0.2);
    const double before = sheet.way();
    sheet.run_until(1);
    EXPECT_NEAR(sheet.way(), before, 2e-5);
}

TEST_P(ClothOnClothSlope, SlidesAsTheFormulaSays) {
    struct Slide {
        double tangent, friction, from, to;
    };
    for (const Slide& slide : {Slide{1.02 * 0.3, 0.3, 0.2, 1}, {0.6, 0.3, 0.02, 0.25}, {0.3, 0, 0.02, 0.25}}) {
        SheetOnSlope sheet(GetParam(), slide.tangent, static_cast<Real>(slide.friction));
        sheet.run_until(slide.from);
        const double start = sheet.time(), before = sheet.way();
        sheet.run_until(slide.to);
        const double cosine = 1 / std::hypot(1, slide.tangent);
        const double acceleration = 9.81 * cosine * (slide.tangent - slide.friction);
        const double way = acceleration * (sheet.time() * sheet.time() - start * start) / 2;
        EXPECT_NEAR(sheet.way() - before, way, 0.02 * way) << slide.tangent << ", friction " << slide.friction;
    }
}

}  // namespace
}  // namespace drape
