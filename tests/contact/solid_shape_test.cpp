#include "drape/contact/solid_shape.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "contact/detect/deepest_point.h"
#include "drape/base/exact_math.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

Vec3 draw_point(std::mt19937& random, Real size) {
    Vec3 p;
    for (Real& coordinate : p) coordinate = size * uniform<Real>(random);
    return p;
}

/// @param far from the origin, at most
/// @param size of the triangle
std::array<Vec3, 3> draw_triangle(std::mt19937& random, Real far, Real size) {
    std::array<Vec3, 3> corners;
    corners.fill(draw_point(random, far));
    for (Vec3& corner : corners) corner += draw_point(random, size);
    return corners;
}

/// The least of what is measured on a grid of points of a triangle.
template <class Measure>
Real sampled_least(const std::array<Vec3, 3>& corners, int parts, Measure measure) {
    Real least = std::numeric_limits<Real>::infinity();
    for (int i = 0; i <= parts; ++i) {
        for (int j = 0; i + j <= parts; ++j) {
            const Real u = Real(i) / Real(parts), v = Real(j) / Real(parts);
            least =
                std::min(least, measure(corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0])));
        }
    }
    return least;
}

/// The solid angle that a triangle fills, over 4 pi; summed over a closed surface 1 inside and 0 outside.
/// @cite vanoosterom1983
double winding(const Vec3& p, Vec3 a, Vec3 b, Vec3 c) {
    a -= p, b -= p, c -= p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double across = a.dot(b.cross(c)), along = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return std::atan2(across, along) / (2 * 3.14159265358979323846);
}

struct Brute {
    Real distance = std::numeric_limits<Real>::infinity();  ///< without its sign
    double inside = 0;

    Brute(const TriangleMesh& mesh, const Vec3& p) {
        const auto at = [&](int k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(k)]; };
        for (const auto& [i, j, k] : mesh.triangles) {
            distance = std::min(distance, distance_to_triangle(p, at(i), at(j), at(k)));
            inside += winding(p, at(i), at(j), at(k));
        }
    }
    [[nodiscard]] Real signed_distance() const { return inside > 0.5 ? -distance : distance; }
};

/// A closed surface with dents and spikes: a sphere of rings whose radius is drawn for each point.
TriangleMesh spiky(std::mt19937& random) {
    constexpr int rings = 7, columns = 9;
    TriangleMesh mesh;
    mesh.points.emplace_back(0, -1, 0);
    const double pi = 3.14159265358979323846;
    for (int r = 0; r < rings; ++r) {
        for (int c = 0; c < columns; ++c) {
            const double polar = pi * (r + 1) / (rings + 1), turn = 2 * pi * c / columns;
            const double radius = 0.75 + 0.4 * uniform<Real>(random);
            mesh.points.push_back(
                radius * Vec3(std::sin(polar) * std::cos(turn), -std::cos(polar), -std::sin(polar) * std::sin(turn)));
        }
    }
    mesh.points.emplace_back(0, 1, 0);
    const int top = rings * columns + 1;
    const auto at = [&](int r, int c) { return 1 + r * columns + c % columns; };
    for (int c = 0; c < columns; ++c) {
        mesh.triangles.push_back({0, at(0, c + 1), at(0, c)});
        mesh.triangles.push_back({top, at(rings - 1, c), at(rings - 1, c + 1)});
        for (int r = 0; r + 1 < rings; ++r) {
            mesh.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c)});
            mesh.triangles.push_back({at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
        }
    }
    return mesh;
}

void expect_surface(const SolidShape& shape, const TriangleMesh& mesh, std::mt19937& random, Real tolerance) {
    const std::array<Vec3, 2> extent = shape.extent();
    const Vec3 half = Real(0.5) * (extent[1] - extent[0]), middle = Real(0.5) * (extent[1] + extent[0]);
    for (int trial = 0; trial < 300; ++trial) {
        const Vec3 p = middle + Real(1.5) * half.cwiseProduct(draw_point(random, 1));
        const SurfaceDistance found = shape.measure(p);
        ASSERT_NEAR(found.distance, Brute(mesh, p).signed_distance(), tolerance) << p.transpose();
        ASSERT_NEAR(found.normal.norm(), 1, 1e-12);
        // One distance along the normal leads to the surface
        ASSERT_NEAR(Brute(mesh, p - found.distance * found.normal).distance, 0, tolerance) << p.transpose();
    }
}

TEST(SolidShape, ABoxAndACapsuleAreAsFarAsTheTrianglesOfTheirSurfaces) {
    std::mt19937 random(1);
    const auto box = make_box({0.4, 0.7, 1.1}), capsule = make_capsule(0.2, 0.5);
    expect_surface(*box, box->surface(), random, 1e-12);
    expect_surface(*capsule, capsule->surface(), random, 2e-3);
}

/// With normals that are not weighted by angles, points beside some corners are on the wrong side. @cite baerentzen2005
TEST(SolidShape, AMeshIsAsFarAsItsTrianglesWhateverItsDents) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 8; ++trial) {
        const TriangleMesh mesh = spiky(random);
        expect_surface(*make_mesh_shape(mesh), mesh, random, 1e-12);
    }
}

/// Some triangles cross the surface, or have it cross them, between their corners, which are outside.
TEST(SolidShape, NoPointOfATriangleIsNearerToAMeshThanItsClearance) {
    std::mt19937 random(11);
    const auto mesh = make_mesh_shape(spiky(random));
    int bounded = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        const std::array<Vec3, 3> triangle = draw_triangle(random, Real(1.5), Real(1.6));
        Real corners = std::numeric_limits<Real>::infinity();
        for (const Vec3& corner : triangle) corners = std::min(corners, mesh->measure(corner).distance);
        if (corners <= 0) continue;
        constexpr int parts = 24;
        const Real lowest =
            sampled_least(triangle, parts, [&mesh](const Vec3& p) { return mesh->measure(p).distance; });
        const Real clearance = mesh->clearance(triangle, corners);
        EXPECT_LE(clearance, lowest + Real(1e-6)) << trial;
        const Real between_samples = ((triangle[1] - triangle[0]).norm() + (triangle[2] - triangle[0]).norm()) / parts;
        EXPECT_TRUE(lowest <= between_samples || clearance >= lowest - between_samples) << trial;
        bounded += clearance > corners / 2;
    }
    EXPECT_GT(bounded, 50);
}

void expect_deepest(const Solid& solid, std::mt19937& random) {
    for (int trial = 0; trial < 200; ++trial) {
        const std::array<Vec3, 3> corners = draw_triangle(random, 0.3, 0.1);
        const DeepestPoint found = find_deepest_point(
            solid, corners, {solid.measure(corners[0]), solid.measure(corners[1]), solid.measure(corners[2])});
        const Vec3 there =
            found.barycentric[0] * corners[0] + found.barycentric[1] * corners[1] + found.barycentric[2] * corners[2];
        ASSERT_LT((there - found.point).norm(), 1e-12);
        ASSERT_EQ(solid.distance(found.point), found.surface.distance);
        const Real least = sampled_least(corners, 60, [&solid](const Vec3& p) { return solid.distance(p); });
        ASSERT_TRUE(found.surface.distance <= 0 || found.surface.distance < least + 1e-5);
    }
}

TEST(DeepestPoint, IsAsLowAsAnyPointOfTheTriangleOutsideABoxAndACapsule) {
    std::mt19937 random(5);
    Solid box{.shape = make_box({0.3, 0.2, 0.4})};
    box.orientation = Eigen::AngleAxis<Real>(0.7, Vec3(1, 2, 3).normalized());
    expect_deepest(box, random);
    expect_deepest({.shape = make_capsule(0.1, 0.3)}, random);
}

}  // namespace
}  // namespace drape
