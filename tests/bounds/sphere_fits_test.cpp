#include "drape/bounds/sphere_fits.h"

#include <gtest/gtest.h>

#include "drape/bounds/cloth_quadtree.h"
#include "support/containment.h"
#include "support/point_sets.h"
#include "support/smallest_radius.h"

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
                visit(set.name, patch_of_points(x), x);
            }
        }
    }
    for (const int n : {2, 3, 4, 5, 6, 7, 9, 13, 17, 25, 33}) {
        for (int round = 0; round < 80; ++round) {
            const Grid grid{n, round % 4 == 0 ? n + 3 : n};
            const Points x = test::random_cloth(grid, random);
            visit("cloth", whole(x, grid), x);
        }
    }
}

TEST(SmallestSphere, IsTheSmallestOfAllSpheresThroughAFewPoints) {
    std::mt19937 random(1);
    for (const test::PointSet& set : test::point_sets()) {
        for (int round = 0; round < 120; ++round) {
            const Points x = test::random_points(set, 2 + round % 7, random);
            const Real smallest = test::smallest_radius_by_trying_all(x);
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
            const Real smallest = test::smallest_radius_by_trying_all(x);
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
    for_each_set(11, [&](const std::string& set, const Patch& patch, const Points&) {
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

/// True if every particle is inside, in arithmetic that does not round as the fit did.
bool contains_all(const BoundingSphere& sphere, const Points& x) {
    for (Eigen::Index p = 0; p < x.rows(); ++p) {
        long double square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const long double side = static_cast<long double>(x(p, axis)) - sphere.centre[axis];
            square += side * side;
        }
        if (!(std::sqrt(square) <= sphere.radius)) return false;
    }
    return true;
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
                    EXPECT_TRUE(contains_all(fit(whole(x, grid)), x))
                        << name << " at scale " << scale << ", " << away << " away";
                });
            }
        }
    }
}

TEST(SphereFits, ContainPointsOfEverySort) {
    for_each_set(9, [](const std::string& set, const Patch& patch, const Points& x) {
        for_each_fit(
            [&](Fit fit, const std::string& name) { EXPECT_TRUE(contains_all(fit(patch), x)) << name << ": " << set; });
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
