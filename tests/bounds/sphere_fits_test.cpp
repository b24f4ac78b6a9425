#include "drape/bounds/sphere_fits.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <vector>

#include "drape/bounds/cloth_quadtree.h"
#include "support/containment.h"
#include "support/point_sets.h"

namespace drape {
namespace {

using test::patch_of_points;
using test::whole;
using Fit = BoundingSphere (*)(const Patch&);

const Fit fit_box_sphere = sphere_fit_of(SphereFit::BoxCentre, Kernels::Plain);
const Fit fit_ritter_sphere = sphere_fit_of(SphereFit::Ritter, Kernels::Plain);
const Fit fit_epos6_sphere = sphere_fit_of(SphereFit::Epos6, Kernels::Plain);
const Fit fit_epos14_sphere = sphere_fit_of(SphereFit::Epos14, Kernels::Plain);
const Fit fit_epos26_sphere = sphere_fit_of(SphereFit::Epos26, Kernels::Plain);

Real farthest_distance(const Points& x, const Vec3& centre) {
    return (x.rowwise() - centre.transpose()).rowwise().norm().maxCoeff();
}

/// The radius of the smallest sphere about a few points: of all spheres through two, three or four of them, centred
/// among those, the smallest once it reaches all.
Real smallest_radius_by_trying_all(const Points& x) {
    const int n = static_cast<int>(x.rows());
    Real best = farthest_distance(x, x.row(0).transpose());
    const auto try_support = [&](const std::vector<int>& support) {
        const Eigen::Index others = static_cast<Eigen::Index>(support.size()) - 1;
        Points sides(others, 3);
        for (Eigen::Index k = 0; k < others; ++k) {
            sides.row(k) = x.row(support[static_cast<std::size_t>(k) + 1]) - x.row(support[0]);
        }
        const Vec3 out = sides.completeOrthogonalDecomposition().solve(sides.rowwise().squaredNorm() / 2);
        if (out.allFinite()) best = std::min(best, farthest_distance(x, x.row(support[0]).transpose() + out));
    };
    for (int a = 0; a < n; ++a) {
        for (int b = a + 1; b < n; ++b) {
            try_support({a, b});
            for (int c = b + 1; c < n; ++c) {
                try_support({a, b, c});
                for (int d = c + 1; d < n; ++d) try_support({a, b, c, d});
            }
        }
    }
    return best;
}

/// Calls visit(fit, name) for every fit, plain and by vector kernels.
template <class Visit>
void for_each_fit(Visit visit) {
    for (const Kernels kernels : {Kernels::Vector, Kernels::Plain}) {
        for (const SphereFit kind : values_of<SphereFit>()) {
            visit(sphere_fit_of(kind, kernels), name_of(kernels) + " " + name_of(kind));
        }
    }
}

/// Random sets of every sort, of 2 to 1000 points, and cloth patches of 2 x 2 to 33 x 33 particles.
template <class Visit>
void for_each_set(unsigned seed, Visit visit) {
    std::mt19937 random(seed);
    for (const test::PointSet& set : test::point_sets()) {
        for (const int n : {2, 3, 4, 5, 6, 8, 14, 20, 27, 40, 100, 1000}) {
            for (int round = 0; round < 40; ++round) {
                const Points x = test::random_points(set, n, random);
                visit(set.name, patch_of_points(x));
            }
        }
    }
    for (const int n : {2, 3, 4, 5, 6, 7, 9, 13, 17, 25, 33}) {
        for (int round = 0; round < 80; ++round) {
            const Grid grid{n, round % 4 == 0 ? n + 3 : n};
            const Points x = test::random_cloth(grid, random);
            visit("cloth", whole(x, grid));
        }
    }
}

TEST(BoundingSphere, StandsAtTheMeanAndReachesTheFarthestParticle) {
    std::mt19937 random(5);
    for (int columns = 2; columns < 40; ++columns) {
        const Grid grid{columns, 2 + columns % 7};
        const Points x = test::random_cloth(grid, random);
        const BoundingSphere sphere = BoundingSphere::fit(whole(x, grid));
        const Eigen::RowVector3d mean = x.colwise().mean();
        EXPECT_LT((sphere.centre.transpose() - mean).norm(), 1e-14) << columns;
        EXPECT_NEAR(sphere.radius, (x.rowwise() - mean).rowwise().norm().maxCoeff(), 1e-14) << columns;
    }
}

TEST(SmallestSphere, IsTheSmallestOfAllSpheresThroughAFewPoints) {
    std::mt19937 random(1);
    for (const test::PointSet& set : test::point_sets()) {
        for (int round = 0; round < 120; ++round) {
            const Points x = test::random_points(set, 2 + round % 7, random);
            const Real smallest = smallest_radius_by_trying_all(x);
            EXPECT_NEAR(fit_smallest_sphere(patch_of_points(x)).radius, smallest, 1e-12 * smallest) << set.name;
        }
    }
}

TEST(SmallestSphere, HoldsPointsThatAreNearlyInOnePlaceLinePlaneOrCircle) {
    std::mt19937 random(4);
    for (const test::PointSet& set : test::point_sets()) {
        for (int tenths = 20; tenths < 160; tenths += 3) {
            Points x = test::random_points(set, 5 + tenths % 4, random);
            x += std::pow(10.0, -tenths / 10.0) * test::random_points(test::point_sets()[0], 5 + tenths % 4, random);
            const Real smallest = smallest_radius_by_trying_all(x);
            EXPECT_NEAR(fit_smallest_sphere(patch_of_points(x)).radius, smallest, 1e-9 * smallest + 1e-15) << set.name;
        }
    }
}

TEST(SphereFits, AreAtMostSoMuchTooLarge) {
    struct {
        Fit fit;
        Real limit, limit_of_cloth;
        Real worst = 0, worst_of_cloth = 0;
    } cases[] = {{BoundingSphere::fit, 2, 1.2},   {fit_box_sphere, std::sqrt(3.0), 1.12},
                 {fit_ritter_sphere, 1.30, 1.30}, {fit_epos6_sphere, 1.18, 1.18},
                 {fit_epos14_sphere, 1.06, 1.06}, {fit_epos26_sphere, 1.02, 1.011}};
    for_each_set(11, [&](const std::string& set, const Patch& patch) {
        const Real smallest = fit_smallest_sphere(patch).radius;
        for (auto& one : cases) {
            const Real radius = one.fit(patch).radius;
            EXPECT_GE(radius, smallest * (1 - 1e-12)) << set;
            if (!(smallest > 0)) continue;
            one.worst = std::max(one.worst, radius / smallest);
            if (set == "cloth") one.worst_of_cloth = std::max(one.worst_of_cloth, radius / smallest);
        }
    });
    for (const auto& one : cases) {
        EXPECT_LT(one.worst, one.limit);
        EXPECT_LT(one.worst_of_cloth, one.limit_of_cloth);
    }
}

TEST(SphereFits, ContainTheirParticlesAtAnyScaleAndFarFromTheOrigin) {
    std::mt19937 random(8);
    for (const Real scale : {1e-6, 1.0, 1e6}) {
        for (const Real away : {0.0, 1.0, 1e3, 1e9}) {
            for (int round = 0; round < 30; ++round) {
                const Grid grid{2 + round % 20, 2 + round % 11};
                Points x = scale * test::random_cloth(grid, random);
                x.rowwise() += scale * away * Eigen::RowVector3d(1, -2, 3);
                for_each_fit([&](Fit fit, const std::string& name) {
                    EXPECT_LE(test::farthest_out(fit(whole(x, grid)), whole(x, grid)), 0)
                        << name << " at scale " << scale << ", " << away << " away";
                });
            }
        }
    }
}

TEST(SphereFits, ContainPointsOfEverySort) {
    for_each_set(9, [](const std::string& set, const Patch& patch) {
        for_each_fit([&](Fit fit, const std::string& name) {
            EXPECT_LE(test::farthest_out(fit(patch), patch), 0) << name << ": " << set;
        });
    });
}

TEST(SphereFits, AreChosenBySetting) {
    std::mt19937 random(12);
    const Grid grid{17, 13};
    const Points x = test::random_cloth(grid, random);
    for (const SphereFit kind : values_of<SphereFit>()) {
        const auto tree = make_broad_phase({.sphere_fit = kind}, grid);
        tree->build(x);
        std::vector<NodeView> root;
        tree->nodes_at(0, root);
        EXPECT_EQ(std::get<BoundingSphere>(root.at(0).volume).radius,
                  sphere_fit_of(kind, Kernels::Vector)(whole(x, grid)).radius)
            << name_of(kind);
    }
}

}  // namespace
}  // namespace drape
