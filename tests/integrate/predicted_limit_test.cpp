// The predicted limits of small cloths of all kinds, against all eigenvalues of what one step does to them.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "drape/integrate/stability.h"
#include "integrate/true_limit.h"
#include "support/sanitized.h"

namespace drape {
namespace {

using test::LinearCloth;

constexpr IntegratorKind explicit_kinds[] = {IntegratorKind::ExplicitEuler, IntegratorKind::SymplecticEuler,
                                             IntegratorKind::VelocityVerlet, IntegratorKind::Rk4};

TEST(PredictedLimit, IsComparedHereForEveryMethodThatHasOne) {
    for (const IntegratorKind kind : values_of<IntegratorKind>()) {
        EXPECT_EQ(std::ranges::count(explicit_kinds, kind), has_step_limit(kind) ? 1 : 0) << name_of(kind);
    }
}

/// How the kinds of springs are damped.
enum class Damping { InProportion, Lightly, Unlike, NotAll };

struct Sample {
    ClothModel model;
    ClothState state;
    std::string name;
};

/// A cloth of up to 2 x 8, 4 x 4 or 8 x 2 particles: pins, stiffnesses and dampings over decades, drag or none, flat or
/// drawn out of its shape.
Sample random_sample(Damping damping, std::mt19937& random) {
    const auto draw = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    const auto decades = [&](double low, double high) { return static_cast<Real>(std::pow(10, draw(low, high))); };
    ClothParameters cloth;
    do {
        cloth.particles = {2 + static_cast<int>(random() % 7), 2 + static_cast<int>(random() % 7)};
    } while (cloth.particles.particles() > 16);
    cloth.width = static_cast<Real>(draw(0.5, 1.5)), cloth.height = static_cast<Real>(draw(0.5, 1.5));
    constexpr Pins::Kind pins[] = {Pins::Kind::None, Pins::Kind::Two, Pins::Kind::Row};
    cloth.pinned.kind = pins[random() % 3];
    cloth.drag = random() % 3 == 0 ? Real(0) : decades(-5, -2);
    const Real base = decades(1, 4), part = decades(-6, -1);
    const Real unit = std::sqrt(base * cloth.mass / static_cast<Real>(cloth.particles.particles()));  // of zeta
    for (SpringLaw* law : {&cloth.structural, &cloth.shear, &cloth.bend}) {
        law->stiffness = base * decades(-2, 0);
        switch (damping) {
            case Damping::InProportion:
                law->damping = part * law->stiffness;
                break;
            case Damping::Lightly:
                law->damping = unit * decades(-4, -2);
                break;
            case Damping::NotAll:
                law->damping = random() % 2 == 0 ? Real(0) : unit * decades(-3, 0.5);
                break;
            case Damping::Unlike:
                law->damping = unit * decades(-3, 0.5);
        }
    }
    Sample sample{make_cloth_model(cloth), make_rest_state(cloth),
                  std::to_string(cloth.particles.nx) + "x" + std::to_string(cloth.particles.ny)};
    const Real drawn = static_cast<Real>(std::array{0.0, 0.02, 0.2}[random() % 3]) * sample.model.hx;
    for (Eigen::Index k = 0; k < sample.state.x.size(); ++k) {
        sample.state.x.data()[k] += drawn * static_cast<Real>(draw(-1, 1));
    }
    return sample;
}

struct MatrixCase {
    Damping damping;
    int samples;
};

class OneStepMatrix : public ::testing::TestWithParam<MatrixCase> {};

TEST_P(OneStepMatrix, HasNoGrowthBelowThePredictedLimitAndSomeAboveWhereThatIsExact) {
    const Damping damping = GetParam().damping;
    std::mt19937 random(static_cast<unsigned>(damping) + 1);
    const int samples = GetParam().samples;
    int exact = 0;
    for (int n = 0; n < samples; ++n) {
        const Sample sample = random_sample(damping, random);
        const LinearCloth linear(sample.model, sample.state);
        for (const IntegratorKind kind : explicit_kinds) {
            const StepLimit predicted = predicted_limit(sample.model, sample.state, kind, Kernels::Vector);
            const double limit = linear.limit(kind), step = static_cast<double>(predicted.step);
            const std::string name = std::string(name_of(kind)) + ", " + sample.name + ", " + std::to_string(n);
            // A limit of 0 comes out as rounding errors
            EXPECT_LE(step, 1.005 * limit + 1e-12) << name;
            if (kind == IntegratorKind::SymplecticEuler) {
                EXPECT_FALSE(predicted.at_least) << name;
            }
            const bool light = damping == Damping::InProportion || damping == Damping::Lightly;
            if (light && kind != IntegratorKind::ExplicitEuler) {
                EXPECT_GE(step, 0.99 * limit) << name;
            }
            if (predicted.at_least) continue;
            ++exact;
            EXPECT_GE(step, 0.9 * limit) << name;
        }
    }
    EXPECT_GE(exact, 2 * samples);
}

std::string case_name(const ::testing::TestParamInfo<MatrixCase>& info) {
    return std::array{"InProportion", "Lightly", "Unlike", "NotAll"}[static_cast<std::size_t>(info.param.damping)];
}

/// Eigenvalues take fifty times as long with sanitizers.
constexpr int few_samples = test::sanitized ? 6 : 20, many_samples = 60;

INSTANTIATE_TEST_SUITE_P(Long, OneStepMatrix, ::testing::Values(MatrixCase{Damping::NotAll, few_samples}), case_name);
INSTANTIATE_TEST_SUITE_P(Nightly, OneStepMatrix,
                         ::testing::Values(MatrixCase{Damping::InProportion, many_samples},
                                           MatrixCase{Damping::Lightly, many_samples},
                                           MatrixCase{Damping::Unlike, many_samples},
                                           MatrixCase{Damping::NotAll, many_samples}),
                         case_name);

Sample sample_of(const ClothParameters& cloth) { return {make_cloth_model(cloth), make_rest_state(cloth), ""}; }

// Two cloths whose predicted limits were 7 times and 4 % too long
TEST(PredictedLimit, OfExplicitEulerLooksAtTheVibrationsThatOnlyTheAirDamps) {
    ClothParameters cloth;
    cloth.particles = {12, 20};
    cloth.pinned.kind = Pins::Kind::Border;
    cloth.structural = cloth.bend = {300, 0};
    cloth.shear = {300, 1};
    cloth.drag = Real(0.01);
    const Sample sample = sample_of(cloth);
    const StepLimit limit = predicted_limit(sample.model, sample.state, IntegratorKind::ExplicitEuler, Kernels::Vector);
    EXPECT_TRUE(limit.at_least);
    EXPECT_LE(limit.step, Real(4.34e-5)) << "the step at which the matrix of one step has an eigenvalue of length 1";
    EXPECT_GT(limit.step, Real(4e-6));
}

TEST(PredictedLimit, OfRk4LooksAtTheVibrationsThatAreDampedLeast) {
    ClothParameters cloth;
    cloth.particles = {5, 10};
    cloth.width = 1;
    cloth.height = Real(0.5);
    cloth.pinned.kind = Pins::Kind::Row;
    cloth.structural = {Real(578.451), 0};
    cloth.shear = {Real(203.885), Real(0.8319)};
    cloth.bend = {0, Real(0.02)};
    cloth.drag = Real(0.01);
    const Sample sample = sample_of(cloth);
    const StepLimit limit = predicted_limit(sample.model, sample.state, IntegratorKind::Rk4, Kernels::Vector);
    EXPECT_LE(limit.step, Real(0.92) * Real(2.84e-3 / 0.96));
    EXPECT_GT(limit.step, Real(0.85) * Real(2.84e-3 / 0.96));
}

}  // namespace
}  // namespace drape
