#include "drape/contact/detection.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

#include "drape/base/exact_math.h"
#include "drape/bounds/displacement.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

constexpr Real thickness = 0.002;

/// A sheet of one metre in the plane y = height, somewhat crumpled.
Points sheet(const Grid& grid, Real height, Real crumple, std::mt19937& random) {
    Points x(grid.particles(), 3);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            x.row(grid.particle(i, j)) << Real(i) / (grid.nx - 1) - 0.5 + crumple * uniform<Real>(random),
                height + crumple * uniform<Real>(random), Real(j) / (grid.ny - 1) - 0.5;
        }
    }
    return x;
}

std::vector<CellRange> all_cells_of(const Grid& grid) { return {all_cells(grid)}; }

/// Right-angled triangles, and some with equal sides.
TEST(SolidContacts, AnEdgeOfABoxUnderTheMiddleOfTrianglesIsFound) {
    const Grid grid{2, 2};
    for (const bool are_right : {true, false}) {
        const Real z = are_right ? Real(1) : std::sqrt(Real(0.75)), shear = are_right ? Real(0) : Real(0.5);
        Points x(4, 3);
        x << -1 - shear, 0.1, -z, 1 - shear, 0.1, -z, -1 + shear, 0.1, z, 1 + shear, 0.1, z;
        // Its top is at 0.1; it is below the middle of a side, or of a triangle
        const Solid box{.shape = make_box({0.2, 0.2, 0.2}),
                        .position = Vec3(are_right ? 0 : -shear, 0, are_right ? 0 : -z / 3)};
        std::vector<ContactRow> contacts;
        SolidSearch().find({grid, x, x}, box, {0, thickness, 0}, all_cells_of(grid), contacts);
        ASSERT_FALSE(contacts.empty()) << are_right;
        for (const ContactRow& contact : contacts) {
            EXPECT_EQ(contact.kind, RowKind::Triangle);
            EXPECT_NEAR(contact.depth, thickness, 1e-6);
            EXPECT_NEAR(contact.normal.y(), 1, 1e-6);
        }
    }
}

TEST(SolidContacts, EveryParticleWithinTheThicknessIsAContactOnceAndInTheOrderOfTheWarmStart) {
    std::mt19937 random(1);
    const Grid grid{20, 20};
    const Solid capsule{.shape = make_capsule(0.3, 0.3), .position = {0.03, -0.15, 0.01}};
    const Points x = sheet(grid, 0.28, 0.01, random);
    std::vector<ContactRow> contacts;
    SolidSearch().find({grid, x, x}, capsule, {2, thickness, 0}, all_cells_of(grid), contacts);
    std::vector<int> particles;
    for (const ContactRow& contact : contacts) {
        EXPECT_EQ(contact.body, 2);
        if (contact.kind == RowKind::Particle) particles.push_back(contact.particles[0].particle);
    }
    std::ranges::sort(particles);
    std::vector<int> expected;
    for (int p = 0; p < grid.particles(); ++p) {
        if (capsule.distance(x.row(p).transpose()) < thickness) expected.push_back(p);
    }
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(particles, expected);
    EXPECT_TRUE(std::ranges::is_sorted(contacts, [](const auto& a, const auto& b) { return compare(a, b) < 0; }));
}

/// Of a box, and of the ground, which is below all of a cloth, in it, or above most of it.
TEST(SolidContacts, EveryHierarchyFindsTheSameAsBruteForceAndPrunes) {
    std::mt19937 random(2);
    const Grid grid{33, 29};
    Solid box{.shape = make_box({0.3, 0.2, 0.15})};
    box.orientation = Eigen::AngleAxis<Real>(1.1, Vec3(3, 1, 2).normalized());
    int touching = 0;
    std::int64_t pruned = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const Points x = test::random_cloth(grid, random);
        const Real bottom = x.col(1).minCoeff(), part = Real(0.05) * static_cast<Real>(trial - 2);
        const Real height = bottom + part * (x.col(1).maxCoeff() - bottom) - thickness;
        const auto find = [&](bool by_box, const std::vector<CellRange>& cells) {
            std::vector<ContactRow> contacts;
            if (by_box) SolidSearch().find({grid, x, x}, box, {0, thickness, 0}, cells, contacts);
            if (!by_box) find_ground_contacts({grid, x, x}, height, {0, thickness}, cells, contacts);
            return contacts;
        };
        const std::array expected{find(false, all_cells_of(grid)), find(true, all_cells_of(grid))};
        for (const auto volume : {VolumeKind::Sphere, VolumeKind::Aabb, VolumeKind::Kdop18, VolumeKind::Obb}) {
            for (const UpdateKind update : values_of<UpdateKind>()) {
                const auto tree = make_broad_phase({.volume = volume, .update = update, .leaf_cells = 3}, grid);
                Points start = x;
                start.col(1).array() += 0.03;
                tree->build(start);
                tree->build(x);
                for (const bool by_box : {true, false}) {
                    const auto distance = [&](const Vec3& p) { return by_box ? box.distance(p) : p.y() - height; };
                    Candidates near;
                    pruned += tree->query_near(distance, thickness, near).pruned;
                    std::ranges::sort(near.cells, {}, &CellRange::first);
                    const auto found = find(by_box, near.cells);
                    ASSERT_TRUE(std::ranges::equal(found, expected[by_box], [](const auto& a, const auto& b) {
                        return compare(a, b) == 0 && a.depth == b.depth;
                    }));
                    touching += !found.empty();
                }
            }
        }
    }
    EXPECT_GT(touching, 100);
    EXPECT_GT(pruned, 1000);
}

/// A search that has seen the cloth before measures only what can have come near since.
TEST(SolidContacts, WhatIsKnownOfTrianglesChangesNoContact) {
    std::mt19937 random(6);
    const Grid grid{15, 15};
    for (const auto& shape : {make_box({0.4, 0.1, 0.3}), make_mesh_shape(make_box({0.4, 0.1, 0.3})->surface())}) {
        Solid solid{.shape = shape};
        SolidSearch search;
        std::size_t found = 0;
        for (int step = 0; step < 200; ++step) {
            const Points x = sheet(grid, 0.06 + 0.1 * uniform<Real>(random), 0.02, random);
            solid.position.x() = 0.1 * uniform<Real>(random);
            std::vector<ContactRow> contacts, expected;
            search.find({grid, x, x}, solid, {0, thickness, 0}, all_cells_of(grid), contacts);
            SolidSearch().find({grid, x, x}, solid, {0, thickness, 0}, all_cells_of(grid), expected);
            ASSERT_EQ(contacts.size(), expected.size());
            for (std::size_t c = 0; c < contacts.size(); ++c) ASSERT_EQ(contacts[c].depth, expected[c].depth);
            found += contacts.size();
        }
        EXPECT_GT(found, 1000u);
    }
}

/// A plate thinner than the cloth is passed in one step, from either side, or turns the cloth's contact to its back.
TEST(SolidContacts, WhatPassesAThinPlateWithinAStepIsHeldOnItsSide) {
    std::mt19937 random(4);
    const Grid grid{12, 12};
    Solid plate{.shape = make_box({1.4, 0.0005, 1.4})};
    for (const Real end : {-0.5, -0.05, -0.001, -0.0002}) {
        const Points before = sheet(grid, 0.05, 0.005, random);
        Points x = before;
        x.col(1).array() += end - 0.05;
        std::vector<ContactRow> contacts;
        const Real moved = 0.05 - end;
        SolidSearch().find({grid, before, x}, plate, {0, thickness, moved}, all_cells_of(grid), contacts);
        std::vector<bool> held(static_cast<std::size_t>(grid.particles()));
        for (const ContactRow& contact : contacts) {
            if (contact.kind != RowKind::Particle) continue;
            EXPECT_NEAR(contact.normal.y(), 1, 1e-9);
            EXPECT_NEAR(contact.depth, 0.00025 + thickness - contact.point(x).y(), 1e-9);
            held[static_cast<std::size_t>(contact.particles[0].particle)] = true;
        }
        for (int p = 0; p < grid.particles(); ++p) {
            EXPECT_TRUE(x(p, 1) >= thickness || held[static_cast<std::size_t>(p)]) << p << " to " << end;
        }
    }
}

TEST(SolidContacts, AMovingSolidCarriesWhatItMeets) {
    const Grid grid{2, 2};
    Points x(4, 3);
    x << -1, 0, -1, 1, 0, -1, -1, 0, 1, 1, 0, 1;
    Solid ball{.shape = make_capsule(0.1, 0.001), .position = {0.3, 0.5, 0.2}};
    ball.moved = {0, 1.0, 0};  // from below the sheet to above it
    std::vector<ContactRow> contacts;
    SolidSearch().find({grid, x, x}, ball, {0, thickness, 1}, all_cells_of(grid), contacts);
    ASSERT_FALSE(contacts.empty());
    const ContactRow& deepest = std::ranges::max(contacts, {}, &ContactRow::depth);
    EXPECT_NEAR(deepest.normal.y(), 1, 1e-3);
    EXPECT_NEAR(deepest.depth, 0.5 + 0.1 + 0.0005 + thickness, 1e-3);
}

/// A box and a mesh of its surface are touched by nearly the same triangles, in short and long steps, at rest and
/// moving.
TEST(SolidContacts, AMeshOfABoxIsTouchedByTheTrianglesThatTouchTheBox) {
    std::mt19937 random(6);
    const Grid grid{16, 16};
    std::size_t of_box = 0, of_mesh = 0, of_both = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const auto shape = make_box({Real(0.5), Real(0.2), Real(0.4)});
        Solid box{.shape = shape, .position = {0, Real(-0.1), 0}};
        box.orientation = Eigen::AngleAxis<Real>(uniform<Real>(random), Vec3(1, 2, 3).normalized());
        box.moved = trial % 2 == 0 ? Vec3::Zero() : Vec3(0, Real(0.05) * uniform<Real>(random), 0);
        Solid mesh = box;
        mesh.shape = make_mesh_shape(shape->surface());
        const Points before = sheet(grid, Real(0.2), Real(0.02), random);
        Points x = before;
        x.col(1).array() -= Real(0.1) + Real(0.1) * uniform<Real>(random);
        const auto touched = [&](const Solid& solid) {
            std::vector<ContactRow> contacts;
            const Real reach = largest_displacement(x, before) + solid.moved.norm();
            SolidSearch().find({grid, before, x}, solid, {0, thickness, reach}, all_cells_of(grid), contacts);
            std::vector<int> triangles;
            for (const ContactRow& contact : contacts) {
                if (contact.kind == RowKind::Triangle) triangles.push_back(contact.triangle);
            }
            std::ranges::sort(triangles);
            return triangles;
        };
        const std::vector<int> by_box = touched(box), by_mesh = touched(mesh);
        std::vector<int> by_both;
        std::ranges::set_intersection(by_box, by_mesh, std::back_inserter(by_both));
        of_box += by_box.size(), of_mesh += by_mesh.size(), of_both += by_both.size();
    }
    EXPECT_GT(of_both, 200u);
    EXPECT_GT(20 * of_both, 19 * std::max(of_box, of_mesh)) << of_box << " " << of_mesh << " " << of_both;
}

}  // namespace
}  // namespace drape
