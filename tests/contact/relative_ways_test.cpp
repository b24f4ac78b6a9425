// How particles move but for what all move by together, plain and by vectors.

#include "drape/contact/relative_ways.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace drape {
namespace {

constexpr Kernels both[] = {Kernels::Plain, Kernels::Vector};

struct ThreeTimes {
    explicit ThreeTimes(int particles) {
        std::mt19937 random(3);
        std::uniform_real_distribution<Real> unit(-1, 1);
        for (Points* x : {&kept, &before, &now}) *x = Points::NullaryExpr(particles, 3, [&] { return unit(random); });
    }
    [[nodiscard]] RelativeWays ways() const {
        return {kept, before, now, Vec3(Real(0.1), Real(0.2), Real(-0.3)), Vec3(Real(0.02), 0, Real(-0.01))};
    }
    [[nodiscard]] Real way(Eigen::Index p) const {
        return (now.row(p) - before.row(p) - ways().common.transpose()).norm();
    }
    [[nodiscard]] Real stray(Eigen::Index p) const {
        return (before.row(p) - kept.row(p) - ways().since_kept.transpose()).norm();
    }

    Points kept, before, now;
};

TEST(RelativeWays, AddUpToWhatAllMoveBy) {
    for (const int particles : {1, 5, 16, 47}) {
        const ThreeTimes times(particles);
        for (const Kernels kernels : both) {
            const auto [at, way] = sum_ways(times.before, times.now, kernels);
            const Real tolerance = 100 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(particles);
            EXPECT_LT((at - times.before.colwise().sum().transpose()).norm(), tolerance);
            EXPECT_LT((way - (times.now - times.before).colwise().sum().transpose()).norm(), tolerance);
        }
    }
}

TEST(RelativeWays, AreReachAndStrayOfEachParticle) {
    const ThreeTimes times(47);
    for (const Kernels kernels : both) {
        std::vector<Real> allowed(47, 100), reaches(47), strayed(47);
        EXPECT_TRUE(find_reaches(times.ways(), Real(0.01), Real(1.5), allowed, reaches, strayed, kernels));
        for (std::size_t k = 0; k < 47; ++k) {
            const auto p = static_cast<Eigen::Index>(k);
            EXPECT_NEAR(reaches[k], Real(0.01) + Real(1.5) * times.way(p), 1e-6);
            EXPECT_NEAR(strayed[k], reaches[k] + times.stray(p), 1e-6);
        }
        const std::vector<Real> found = strayed;
        allowed = strayed;
        EXPECT_TRUE(find_reaches(times.ways(), Real(0.01), Real(1.5), allowed, reaches, strayed, kernels));
        for (std::size_t k = 0; k < 47; ++k) {
            allowed[k] *= Real(0.999);
            EXPECT_FALSE(find_reaches(times.ways(), Real(0.01), Real(1.5), allowed, reaches, strayed, kernels)) << k;
            allowed[k] = found[k];
        }
    }
}

TEST(RelativeWays, AreWithinReachOnlyIfEachIs) {
    const ThreeTimes times(47);
    std::vector<Real> reaches(47);
    for (std::size_t k = 0; k < 47; ++k) reaches[k] = times.way(static_cast<Eigen::Index>(k)) + Real(0.011);
    for (const Kernels kernels : both) {
        EXPECT_TRUE(are_within(times.ways(), Real(0.01), reaches, kernels));
        for (Real& reach : reaches) {
            reach -= Real(0.002);
            EXPECT_FALSE(are_within(times.ways(), Real(0.01), reaches, kernels));
            reach += Real(0.002);
        }
    }
}

}  // namespace
}  // namespace drape
