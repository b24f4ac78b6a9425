// Meshes from STL files, text and binary.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

#include "drape/base/scratch_folder.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

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

class StlFile : public testing::Test {
protected:
    Simulation simulation(const std::string& bytes, const std::string& file = "mesh.stl") const {
        std::ofstream(folder_.path() / file, std::ios::binary) << bytes;
        const std::string scene = "[cloth]\nparticles = [3, 3]\n[[solid]]\nshape = \"mesh\"\nfile = \"" + file + "\"\n";
        return {"mine", parse_scene(scene, (folder_.path() / "mine.toml").string())};
    }

    /// What is said of a mesh, from the name of its file on.
    [[nodiscard]] std::string error_of(const std::string& bytes) const {
        const std::string error = input_error_of([&] { simulation(bytes); });
        const std::size_t name = error.find("mesh.stl");
        return name == std::string::npos ? error : error.substr(name);
    }

    ScratchFolder folder_;
};

TEST_F(StlFile, IsReadAsTextAndAsBytes) {
    for (const std::string& bytes : {text_of(facets()), binary_of(facets()), binary_of(facets(), "")}) {
        for (const char* file : {"mesh.stl", "MESH.STL"}) {
            const Simulation read = simulation(bytes, file);
            EXPECT_NEAR(read.solids()[0].distance({0.1, 0.1, 0.1}), -0.1, 1e-12);
            EXPECT_NEAR(read.solids()[0].distance({0.1, 0.1, -0.5}), 0.5, 1e-12);
            EXPECT_EQ(read.solids()[0].shape->surface().points.size(), 4u) << "corners in one place are one point";
        }
    }
}

TEST_F(StlFile, BothZerosAreOnePlace) {
    std::vector<Facet> all = facets();
    for (auto& corner : all[2]) {
        for (float& x : corner) x = x == 0 ? -0.0F : x;
    }
    EXPECT_EQ(simulation(binary_of(all)).solids()[0].shape->surface().points.size(), 4u);
}

TEST_F(StlFile, CornersThatAreNotExactlyInOnePlaceLeaveAHole) {
    std::vector<Facet> all = facets();
    all[3][0][0] = std::nextafter(1.0F, 2.0F);
    EXPECT_THAT(error_of(binary_of(all)),
                AllOf(HasSubstr("mesh.stl: byte "), HasSubstr(": facet: the side from point "),
                      HasSubstr("is of one triangle alone: allowed only a closed surface of one orientation")));
}

TEST_F(StlFile, BadTextIsNamedWithLineValueAndRange) {
    const std::string text = text_of(facets());
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        return error_of(changed.replace(changed.find(from), from.size(), to));
    };
    EXPECT_EQ(error_of(""), "mesh.stl: 0 faces: allowed a closed mesh of at least 4");
    EXPECT_EQ(error_of("solid a\nendsolid a\n"), "mesh.stl: 0 faces: allowed a closed mesh of at least 4");
    EXPECT_EQ(error_of("v 0 0 0\n"), "mesh.stl:1: 'v': allowed 'solid' here");
    EXPECT_EQ(with("vertex 0 0 0", "vertex 0 zero 0"),
              "mesh.stl:4: vertex: 'zero': allowed three numbers, each -1000 <= x <= 1000 m");
    EXPECT_THAT(with("vertex 0 0 0", "vertex 0 nan 0"), HasSubstr("mesh.stl:4: vertex: 'nan'"));
    EXPECT_THAT(with("vertex 0 0 0", "vertex 1e9 0 0"), HasSubstr("mesh.stl:4: vertex: '1e9'"));
    EXPECT_THAT(with("vertex 0 0 0", "vertex 0 0"), HasSubstr("mesh.stl:4: vertex: ''"));
    EXPECT_EQ(with("    outer loop", "    inner loop"), "mesh.stl:3: 'inner': allowed 'outer' here");
    EXPECT_EQ(with("    endloop", "vertex 0 0 1"), "mesh.stl:7: 'vertex': allowed 'endloop' here");
    EXPECT_EQ(with("  endfacet", "facet"), "mesh.stl:8: 'facet': allowed 'endfacet' here");
    EXPECT_EQ(with("  facet", "facets"), "mesh.stl:2: 'facets': allowed 'facet' or 'endsolid' here");
    EXPECT_EQ(with("endsolid a name\n", ""), "mesh.stl:34: the file ends: allowed 'facet' or 'endsolid' here");
    EXPECT_THAT(error_of(text.substr(0, 150)), HasSubstr("mesh.stl:12: the file ends: allowed 'vertex' here"));
    EXPECT_THAT(with("vertex 0 1 0", "vertex 0 0 0"), HasSubstr("mesh.stl:6: facet: a triangle without area"));
    EXPECT_THAT(error_of("solid " + std::string(5000, 'a')), HasSubstr("mesh.stl:1: a line of more than 4096 bytes"));
}

TEST_F(StlFile, BadBytesAreNamedWithTheirPlaceValueAndRange) {
    std::vector<Facet> all = facets();
    std::string cut_off = binary_of(all, "");
    cut_off.pop_back();
    EXPECT_EQ(
        error_of(cut_off),
        "mesh.stl: 283 bytes: allowed 284, for the 4 triangles that byte 80 says a binary STL file has, or a text "
        "that begins with 'solid'");
    all[1][2][1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(error_of(binary_of(all)),
              "mesh.stl: byte 174: corner: 'nan': allowed three numbers, each -1000 <= x <= 1000 m");
    all[1][2][1] = 1e30F;
    EXPECT_THAT(error_of(binary_of(all)), HasSubstr("mesh.stl: byte 174: corner: '1.0000000150474662e+30'"));
    all = facets();
    std::swap(all[3][0], all[3][1]);
    EXPECT_THAT(error_of(binary_of(all)), HasSubstr("in the same direction twice"));
    all = facets();
    for (Facet& facet : all) std::swap(facet[0], facet[1]);
    EXPECT_THAT(error_of(binary_of(all)), HasSubstr("a volume of -0.167 m^3"));
    all = facets();
    all[2][1] = all[2][0];
    EXPECT_THAT(error_of(binary_of(all)), HasSubstr("mesh.stl: byte 184: facet: a triangle without area"));
}

TEST_F(StlFile, IsNotReadBeyondItsLimits) {
    const std::vector<Facet> many(200'001, facets()[0]);
    EXPECT_THAT(error_of(binary_of(many)), HasSubstr("too many triangles: allowed at most 200000"));
    std::vector<Facet> wide;
    for (int k = 0; k < 50'000; ++k) {
        const auto x = static_cast<float>(k) / 100;
        wide.push_back({std::array{x, 0.0F, 0.0F}, std::array{x, 1.0F, 0.0F}, std::array{x, 0.0F, 1.0F}});
    }
    EXPECT_THAT(error_of(binary_of(wide)), HasSubstr("too many points: allowed at most 100000"));
    EXPECT_THAT(error_of(std::string(17 * 1024 * 1024, 'x')), HasSubstr("allowed at most 16777216"));
}

}  // namespace
}  // namespace drape
