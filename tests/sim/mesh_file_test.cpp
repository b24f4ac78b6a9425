// Meshes of solids, from OBJ and STL files: what is read, what is mended, and what is refused.

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <vector>

#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "support/input_errors.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

const std::string tetrahedron_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tetrahedron_faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string tetrahedron = tetrahedron_points + tetrahedron_faces;

/// The six faces of a box, counter-clockwise seen from outside, and from inside.
const std::string box_faces =
    "f -8 -7 -5 -6\nf -4 -2 -1 -3\nf -8 -4 -3 -7\nf -6 -5 -1 -2\nf -8 -6 -2 -4\nf -7 -3 -1 -5\n";
const std::string turned_faces =
    "f -6 -5 -7 -8\nf -3 -1 -2 -4\nf -7 -3 -4 -8\nf -2 -1 -5 -6\nf -4 -2 -6 -8\nf -5 -1 -3 -7\n";

std::string box(const Vec3& low, const Vec3& high, const std::string& faces = box_faces) {
    std::ostringstream out;
    for (unsigned corner = 0; corner < 8; ++corner) {
        out << "v " << (corner & 4 ? high : low).x() << " " << (corner & 2 ? high : low).y() << " "
            << (corner & 1 ? high : low).z() << "\n";
    }
    return out.str() + faces;
}

using Facet = std::array<std::array<float, 3>, 3>;

/// A tetrahedron, whose facets are counter-clockwise seen from outside.
std::vector<Facet> facets() {
    constexpr std::array<float, 3> o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

std::string text_of(const std::vector<Facet>& all) {
    std::ostringstream out;
    out << "solid a name\n";
    for (const Facet& facet : all) {
        out << "  facet normal 0 0 0\r\n    outer loop\n";
        for (const auto& [x, y, z] : facet) out << "\tvertex " << x << " " << y << " " << z << "\n";
        out << "    endloop\n  endfacet\n\n";
    }
    out << "endsolid a name\n";
    return out.str();
}

std::string upper_case(std::string text) {
    for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return text;
}

void add_number(std::uint32_t number, std::string& bytes) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xff);
}

/// @param header some begin with the word of a text
std::string binary_of(const std::vector<Facet>& all, std::string header = "solid, but binary") {
    header.resize(80);
    std::string bytes = header;
    add_number(static_cast<std::uint32_t>(all.size()), bytes);
    for (const Facet& facet : all) {
        for (int k = 0; k < 3; ++k) add_number(0x7fc00000, bytes);  // a normal that is no number
        for (const auto& corner : facet) {
            for (const float x : corner) add_number(std::bit_cast<std::uint32_t>(x), bytes);
        }
        bytes += "ab";
    }
    return bytes;
}

class MeshFile : public testing::Test {
protected:
    Simulation simulation(const std::string& file) const {
        const std::string scene = "[cloth]\nparticles = [3, 3]\n[[solid]]\nshape = \"mesh\"\nfile = \"" + file + "\"\n";
        return {"mine", parse_scene(scene, (folder_.path() / "mine.toml").string())};
    }

    /// The solid that a mesh is.
    Solid solid(const std::string& bytes, const std::string& file = "mesh.obj") const {
        std::ofstream(folder_.path() / file, std::ios::binary) << bytes;
        return simulation(file).solids()[0];
    }

    /// What is said of a mesh, from the name of its file on.
    [[nodiscard]] std::string error_of(const std::string& bytes, const std::string& file = "mesh.obj") const {
        const std::string error = input_error_of([&] { solid(bytes, file); });
        const std::size_t name = error.find(file);
        return name == std::string::npos ? error : error.substr(name);
    }

    void expect_tetrahedron(const std::string& bytes, const std::string& file = "mesh.obj") const {
        SCOPED_TRACE(bytes.substr(0, 40));
        const Solid read = solid(bytes, file);
        EXPECT_NEAR(read.distance({0.1, 0.1, 0.1}), -0.1, 1e-6);
        EXPECT_NEAR(read.distance({0.1, 0.1, -0.5}), 0.5, 1e-6);
        EXPECT_EQ(read.shape->surface().points.size(), 4u);
    }

    ScratchFolder folder_;
};

TEST_F(MeshFile, AnObjIsReadWithItsCommentsNormalsAndNegativeNumbers) {
    expect_tetrahedron("# a comment\no name\r\n" + tetrahedron_points +
                       "vn 0 0 1\nvt 0 0\nmtllib /etc/passwd\nusemtl x\nf 1//1 3//1 2/1/1 # the bottom\ng side\n" +
                       "f 1 2 -1\nf 1 4 3\n\nf 2 3 4\r\n");
    expect_tetrahedron("\xEF\xBB\xBF" + tetrahedron);
}

TEST_F(MeshFile, AnStlIsReadAsTextAndAsBytes) {
    const std::string text = text_of(facets()), binary = binary_of(facets());
    for (const std::string& bytes :
         {text, upper_case(text), "\xEF\xBB\xBF" + text, binary, binary + "ab", binary_of(facets(), "") + "ab"}) {
        for (const char* file : {"mesh.stl", "MESH.STL"}) expect_tetrahedron(bytes, file);
    }
}

/// A plate with the outline of an L. Its caps are listed from each corner in turn.
TEST_F(MeshFile, AConcaveFaceIsCutWithinItself) {
    const std::vector<Vec3> outline{{0, 0, 0}, {0.6, 0, 0}, {0.6, 0.2, 0}, {0.2, 0.2, 0}, {0.2, 0.6, 0}, {0, 0.6, 0}};
    const auto lying = make_box({0.6, 0.2, 0.1}), standing = make_box({0.2, 0.6, 0.1});
    for (int start = 0; start < 6; ++start) {
        std::ostringstream out;
        for (const Vec3& p : outline) out << "v " << p.x() << " " << p.y() << " 0\n";
        for (const Vec3& p : outline) out << "v " << p.x() << " " << p.y() << " 0.1\n";
        for (const int cap : {0, 1}) {
            out << "f";
            for (int k = 0; k < 6; ++k) out << " " << (cap == 0 ? 6 - (start + k) % 6 : 7 + (start + k) % 6);
            out << "\n";
        }
        for (int k = 0; k < 6; ++k) {
            const int next = (k + 1) % 6;
            out << "f " << k + 1 << " " << next + 1 << " " << next + 7 << " " << k + 7 << "\n";
        }
        const Solid plate = solid(out.str());
        for (int k = 0; k < 1000; ++k) {
            const Vec3 p(0.08 * (k % 10) - 0.07, 0.08 * (k / 10 % 10) - 0.07, 0.025 * (k / 100) - 0.06);
            const Real expected = std::min(lying->measure(p - Vec3(0.3, 0.1, 0.05)).distance,
                                           standing->measure(p - Vec3(0.1, 0.3, 0.05)).distance);
            const Real distance = plate.distance(p);
            ASSERT_TRUE(expected > 0 ? std::abs(distance - expected) < 1e-6 : distance < 0) << start << ": " << p;
        }
        EXPECT_EQ(plate.shape->surface().triangles.size(), 20u) << start;
    }
}

TEST_F(MeshFile, CornersThatAreNearlyInOnePlaceAreOne) {
    std::vector<Facet> all = facets();
    all[3][0][0] = 1 + 1e-7F;
    for (auto& corner : all[2]) {
        for (float& x : corner) x = x == 0 ? -1e-7F : x;
    }
    expect_tetrahedron(binary_of(all), "mesh.stl");
    all[3][0][0] = 1.001F;
    EXPECT_THAT(error_of(binary_of(all), "mesh.stl"), HasSubstr("is of one triangle alone"));
}

TEST_F(MeshFile, TrianglesWithoutAreaGo) {
    expect_tetrahedron(tetrahedron + "f 1 2 2\n");
    // The edge from 1 to 2 has a point in its middle for one of its triangles, and a triangle without area for the
    // other
    const Solid mended =
        solid(tetrahedron_points + "v 0.5 0 0\nf 1 3 2\nf 1 5 4\nf 5 2 4\nf 1 2 5\nf 1 4 3\nf 2 3 4\n");
    EXPECT_NEAR(mended.distance({0.1, 0.1, 0.1}), -0.1, 1e-6);
    EXPECT_NEAR(mended.distance({0.5, -0.5, 0}), 0.5, 1e-6);
}

TEST_F(MeshFile, EachPartIsTurnedOutwardsByItselfAndMayTouchOthers) {
    for (const std::string& faces : {box_faces, turned_faces}) {
        const Solid read = solid(box({0, 0, 0}, {1, 1, 1}, turned_faces) + box({3, 0, 0}, {4, 1, 1}, faces));
        EXPECT_NEAR(read.distance({0.5, 0.9, 0.5}), -0.1, 1e-6);
        EXPECT_NEAR(read.distance({3.5, 1.1, 0.5}), 0.1, 1e-6);
        const Solid touching = solid(box({0, 0, 0}, {1, 1, 1}) + box({0, 1, 0}, {1, 2, 1}, faces));
        EXPECT_NEAR(touching.distance({1.1, 1, 0.5}), 0.1, 1e-6);
        EXPECT_NEAR(touching.distance({0.9, 1.8, 0.5}), -0.1, 1e-6);
    }
}

TEST_F(MeshFile, APartInsideAnotherIsACavity) {
    for (const std::string& faces : {box_faces, turned_faces}) {
        const Solid read = solid(box({-2, -2, -2}, {2, 2, 2}, faces) + box({-1, -1, -1}, {1, 1, 1}) +
                                 box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, faces));
        EXPECT_NEAR(read.distance({1.9, 0, 0}), -0.1, 1e-6);
        EXPECT_NEAR(read.distance({0.9, 0, 0}), 0.1, 1e-6);
        EXPECT_NEAR(read.distance({0.4, 0, 0}), -0.1, 1e-6);
    }
}

TEST_F(MeshFile, BadInputIsNamedWithLineValueAndRange) {
    EXPECT_EQ(error_of(""), "mesh.obj: 0 faces: allowed a closed mesh of at least 4");
    EXPECT_EQ(error_of("v 0 0 zero\n"), "mesh.obj:1: v: 'zero': allowed three numbers");
    EXPECT_THAT(error_of("v 0 nan 0\n"), HasSubstr("mesh.obj:1: v: 'nan': allowed three numbers"));
    EXPECT_THAT(error_of("v 0 1\n"), HasSubstr("mesh.obj:1: v: ''"));
    EXPECT_EQ(error_of(tetrahedron_points + "f 1 2\n"),
              "mesh.obj:5: f: '': allowed the numbers of three points or more");
    EXPECT_THAT(error_of(tetrahedron_points + "f 1 2 x\n"), HasSubstr("mesh.obj:5: f: 'x'"));
    for (const char* corner : {"5", "0", "-5", "99999999999999999999"}) {
        EXPECT_THAT(error_of(tetrahedron + "f 1 2 " + corner + "\n"),
                    AllOf(HasSubstr("mesh.obj: not read by Assimp (OBJ: "), HasSubstr("allowed a valid obj file")))
            << corner;
    }
    EXPECT_EQ(error_of(tetrahedron + std::string(5000, ' ')), "mesh.obj:9: longer than 4096 bytes");
    EXPECT_THAT(error_of("v 0 1e9 0\n" + tetrahedron), HasSubstr("allowed three numbers, each -1000 <= x <= 1000 m"));
    EXPECT_THAT(error_of("solid\nfacet\nouter loop\nvertex 0 zero 0\n", "mesh.stl"),
                HasSubstr("mesh.stl: not read by Assimp ("));
    EXPECT_EQ(error_of(binary_of(facets()).substr(0, 283), "mesh.stl"),
              "mesh.stl: 283 bytes: allowed at least 284, for the 4 triangles that byte 80 says a binary STL file has");
}

TEST_F(MeshFile, WhatIsNoClosedSurfaceIsRefused) {
    EXPECT_EQ(
        error_of(tetrahedron_points + "f 1 3 2\nf 1 2 4\nf 1 4 3\n" + box({3, 0, 0}, {4, 1, 1})),
        "mesh.obj: the side from (0, 1, 0) to (1, 0, 0) is of one triangle alone: allowed only closed surfaces of "
        "one orientation");
    EXPECT_THAT(error_of(tetrahedron_points + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 4 3\n"),
                HasSubstr("in the same direction twice"));
    EXPECT_THAT(error_of(tetrahedron_points + "f 1 2 3\nf 3 2 1\n"), HasSubstr("mesh.obj: 2 faces"));
    EXPECT_THAT(error_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 4 2 1\nf 4 3 2\n"),
                HasSubstr("part 1 of 1 near (0, 0, 0) has no volume"));
}

TEST_F(MeshFile, ASurfaceThatCrossesItselfIsRefused) {
    EXPECT_THAT(error_of(box({0, 0, 0}, {1, 1, 1}) + box({0.5, 0.5, 0.5}, {2, 2, 2})),
                HasSubstr("mesh.obj: the surface crosses itself near ("));
    // A corner of a box, drawn out through the side that it is not part of
    std::string pierced = box({0, 0, 0}, {1, 1, 1});
    pierced.replace(pierced.find("v 0 0 0"), 7, "v 1.5 0.3 0.4");
    EXPECT_THAT(error_of(pierced), HasSubstr("the surface crosses itself near ("));
}

TEST_F(MeshFile, IsNotReadBeyondItsLimits) {
    std::string points, faces = tetrahedron_points;
    for (int k = 0; k < 100'001; ++k) points += "v 0 0 0\n";
    for (int k = 0; k < 200'001; ++k) faces += "f 1 2 3\n";
    EXPECT_THAT(error_of(points), HasSubstr("mesh.obj:100001: too many points: allowed at most 100000"));
    EXPECT_THAT(error_of(faces), HasSubstr("mesh.obj:200005: too many triangles: allowed at most 200000"));
    EXPECT_THAT(error_of(binary_of(std::vector<Facet>(200'001, facets()[0])), "mesh.stl"),
                HasSubstr("too many triangles: allowed at most 200000"));
    EXPECT_THAT(error_of(std::string(17 * 1024 * 1024, 'x'), "mesh.stl"), HasSubstr("allowed at most 16777216"));
}

TEST_F(MeshFile, IsOneOfTheScenesFolder) {
    for (const char* file : {"../mesh.obj", "/etc/passwd", "a/../../mesh.obj", ".."}) {
        EXPECT_THAT(input_error_of([&] { simulation(file); }),
                    AllOf(HasSubstr("mine.toml:5:8: solid.file = "),
                          HasSubstr("allowed only a file in the scene's folder or below")))
            << file;
    }
    std::filesystem::create_symlink("/etc", folder_.path() / "out");
    EXPECT_THAT(input_error_of([&] { simulation("out/passwd"); }),
                HasSubstr("allowed only a file in the scene's folder"));
    EXPECT_THAT(input_error_of([&] { simulation("none.obj"); }), HasSubstr("none.obj"));
    EXPECT_THAT(input_error_of([&] { simulation("."); }), HasSubstr("folder"));
}

}  // namespace
}  // namespace drape
