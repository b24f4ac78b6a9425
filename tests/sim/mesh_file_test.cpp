#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "drape/base/scratch_folder.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* tetrahedron_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
constexpr const char* tetrahedron_faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

class MeshFile : public testing::Test {
protected:
    void write(const std::string& text) const { std::ofstream(folder_.path() / "mesh.obj") << text; }

    Simulation simulation(const std::string& file = "mesh.obj") const {
        const std::string scene = "[cloth]\nparticles = [3, 3]\n[[solid]]\nshape = \"mesh\"\nfile = \"" + file + "\"\n";
        return {"mine", parse_scene(scene, (folder_.path() / "mine.toml").string())};
    }

    /// What is said of a mesh, from the name of its file on.
    [[nodiscard]] std::string error_of(const std::string& text) const {
        write(text);
        const std::string error = input_error_of([&] { simulation(); });
        const std::size_t name = error.find("mesh.obj");
        return name == std::string::npos ? error : error.substr(name);
    }

    ScratchFolder folder_;
};

TEST_F(MeshFile, IsReadWithItsCommentsNormalsAndNegativeNumbers) {
    write("# a comment\no name\r\n" + std::string(tetrahedron_points) +
          "vn 0 0 1\nvt 0 0\nf 1//1 3//1 2/1/1\nf 1 2 -1\nf 1 4 3\n\nf 2 3 4\r\n");
    const Simulation read = simulation();
    EXPECT_NEAR(read.solids()[0].distance({0.1, 0.1, 0.1}), -0.1, 1e-12);
    EXPECT_NEAR(read.solids()[0].distance({0.1, 0.1, -0.5}), 0.5, 1e-12);
}

TEST_F(MeshFile, APolygonIsCutIntoTriangles) {
    write(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    EXPECT_EQ(simulation().solids()[0].shape->surface().triangles.size(), 12u);
}

TEST_F(MeshFile, BadInputIsNamedWithLineValueAndRange) {
    const std::string points = tetrahedron_points, faces = tetrahedron_faces;
    EXPECT_EQ(error_of(""), "mesh.obj: 0 faces: allowed a closed mesh of at least 4");
    EXPECT_EQ(error_of("v 0 0 zero\n"), "mesh.obj:1: v: 'zero': allowed three numbers, each -1000 <= x <= 1000 m");
    EXPECT_THAT(error_of("v 0 nan 0\n"), HasSubstr("mesh.obj:1: v: 'nan': allowed three numbers"));
    EXPECT_THAT(error_of("v 0 1e9 0\n"), HasSubstr("mesh.obj:1: v: '1e9'"));
    EXPECT_THAT(error_of("v 0 1\n"), HasSubstr("mesh.obj:1: v: ''"));
    EXPECT_THAT(error_of(points + "f 1 2 5\n"), HasSubstr("mesh.obj:5: f: '5': allowed points from 1 to 4"));
    EXPECT_THAT(error_of(points + "f 1 2 0\n"), HasSubstr("mesh.obj:5: f: '0'"));
    EXPECT_THAT(error_of(points + "f 1 2 99999999999999999999\n"), HasSubstr("mesh.obj:5: f: '99999999999999999999'"));
    EXPECT_EQ(error_of(points + "f 1 2\n"), "mesh.obj:5: f: 2 corners: allowed at least 3");
    EXPECT_THAT(error_of(points + "f 1 2 2\n"), HasSubstr("mesh.obj:5: f: a triangle without area"));
    EXPECT_THAT(error_of(points + "f 1 3 2\nf 1 2 4\nf 1 4 3\n"),
                AllOf(HasSubstr("mesh.obj:6: f: the side from point"),
                      EndsWith("allowed only a closed surface of one orientation")));
    EXPECT_THAT(error_of(points + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 4 3\n"), HasSubstr("in the same direction twice"));
    EXPECT_THAT(error_of(points + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"), HasSubstr("a volume of -0.167 m^3"));
    EXPECT_THAT(error_of(points + faces + std::string(5000, ' ')),
                HasSubstr("mesh.obj:9: a line of more than 4096 bytes"));
}

TEST_F(MeshFile, IsNotReadBeyondItsLimits) {
    std::string many;
    for (int k = 0; k < 100'001; ++k) many += "v 0 0 0\n";
    EXPECT_THAT(error_of(many), HasSubstr("mesh.obj:100001: too many points: allowed at most 100000"));
    std::string huge = tetrahedron_points;
    for (int k = 0; k < 200'001; ++k) huge += "f 1 2 3\n";
    EXPECT_THAT(error_of(huge), HasSubstr("too many triangles: allowed at most 200000"));
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
