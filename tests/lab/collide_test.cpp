#include <gmock/gmock.h>

#include <random>

#include "drape/base/numbers.h"
#include "drape/sim/setting_table.h"
#include "lab/lab_run.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;

std::string csv_of(const Points& x) {
    std::string text;
    for (Eigen::Index p = 0; p < x.rows(); ++p) {
        text += real_text(x(p, 0), 17) + "," + real_text(x(p, 1), 17) + "," + real_text(x(p, 2), 17) + "\n";
    }
    return text;
}

std::string grid_text(const Grid& grid) { return std::to_string(grid.nx) + "x" + std::to_string(grid.ny); }

std::string ball_text(const Ball& ball) {
    return real_text(ball.centre[0], 17) + "," + real_text(ball.centre[1], 17) + "," + real_text(ball.centre[2], 17) +
           "," + real_text(ball.radius, 17);
}

/// The touched triangles, each measured on its own.
std::string touched_one_by_one(const Grid& grid, const Points& x, const Ball& ball) {
    std::string text;
    for (int t = 0; t < grid.triangles(); ++t) {
        if (distance_to_triangle(ball.centre, grid, x, t) <= ball.radius) text += std::to_string(t) + "\n";
    }
    return text;
}

/// A rumpled sheet of one unit's size.
Points random_cloth(const Grid& grid, std::mt19937& random, double rumple) {
    std::normal_distribution<double> noise(0, rumple);
    Points x(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) {
        x.row(p) << static_cast<Real>(p % grid.nx) / static_cast<Real>(grid.nx - 1) + noise(random), noise(random),
            static_cast<Real>(p / grid.nx) / static_cast<Real>(grid.ny - 1) + noise(random);
    }
    return x;
}

TEST(LongLabCollide, FindsWhatMeasuringEveryTriangleFinds) {
    const LabFolder folder;
    std::mt19937 random(17);
    std::uniform_real_distribution<double> place(-0.2, 1.2), size(0.01, 0.5);
    std::size_t touched = 0;
    for (int i = 0; i < 60; ++i) {
        const Grid grid{2 + static_cast<int>(random() % 30), 2 + static_cast<int>(random() % 30)};
        const Points x = random_cloth(grid, random, i % 3 == 0 ? 0.2 : 0.01);
        Ball ball{.centre = {place(random), place(random) / 4, place(random)}, .radius = size(random)};
        if (i % 4 == 0) {
            // Just touching one triangle's corner, or just not
            const Vec3 corner = x.row(static_cast<int>(random() % static_cast<unsigned>(grid.particles()))).transpose();
            ball.radius = (corner - ball.centre).norm() * (i % 8 == 0 ? 1 + 1e-12 : 1 - 1e-12);
        }
        const std::string expected = touched_one_by_one(grid, x, ball);
        touched += expected.size();
        folder.write("x.csv", csv_of(x));
        for (const char* method : {"volume=sphere", "volume=brute"}) {
            const LabRun run =
                folder.run({"collide", "--grid", grid_text(grid), "--positions", "x.csv", "--ball", ball_text(ball),
                            "--set", method, "leaf_cells=" + std::to_string(1 + i % 5)});
            ASSERT_EQ(run.code, 0) << run.err;
            EXPECT_EQ(run.out, expected) << grid_text(grid) << " " << ball_text(ball) << " " << method;
        }
    }
    EXPECT_GT(touched, 10'000u);
}

TEST(LongLabCollide, GivesTheSameTrianglesWithEveryVolumeFitUpdateAndLeafSize) {
    const LabFolder folder;
    std::mt19937 random(18);
    const Grid grid{19, 14};
    const Points x = random_cloth(grid, random, 0.02);
    const Ball ball{.centre = {0.4, 0.1, 0.6}, .radius = 0.25};
    folder.write("x.csv", csv_of(x));
    const auto triangles_with = [&](const std::vector<std::string>& settings) {
        std::vector<std::string> words{"collide", "--grid", grid_text(grid), "--positions",
                                       "x.csv",   "--ball", ball_text(ball), "--set"};
        words.insert(words.end(), settings.begin(), settings.end());
        return folder.run(words).out;
    };
    const std::string expected = touched_one_by_one(grid, x, ball);
    EXPECT_GT(lines_of(expected).size(), 20u);
    int leaf_cells = 0;
    for (const std::string& update : find_setting("contact.update").choices) {
        for (const std::string& volume : find_setting("contact.volume").choices) {
            const std::string leaf = std::to_string(1 + leaf_cells++ % 9);
            EXPECT_EQ(triangles_with({"volume=" + volume, "update=" + update, "leaf_cells=" + leaf}), expected)
                << volume << " " << update << " " << leaf;
        }
        for (const std::string& fit : find_setting("contact.sphere_fit").choices) {
            const std::string leaf = std::to_string(1 + leaf_cells++ % 9);
            EXPECT_EQ(triangles_with({"sphere_fit=" + fit, "update=" + update, "leaf_cells=" + leaf}), expected)
                << fit << " " << update << " " << leaf;
        }
    }
}

class LabCollideInput : public testing::Test {
protected:
    LabRun collide(const std::string& grid, const std::string& positions, const std::string& ball) const {
        folder_.write("x.csv", positions);
        return folder_.run({"collide", "--grid", grid, "--positions", "x.csv", "--ball", ball});
    }
    /// Two triangles in a unit square at height 0.
    const std::string square_ = "0,0,0\n1,0,0\n0,0,1\n1,0,1\n";
    LabFolder folder_;
};

TEST_F(LabCollideInput, GivesTriangleNumbersAndCounters) {
    const LabRun both = collide("2x2", square_, "0.5,0,0.5,0.1");
    EXPECT_EQ(both.out, "0\n1\n");
    EXPECT_EQ(both.code, 0);
    EXPECT_THAT(both.err, MatchesRegex("nodes=[0-9]+ visited=[0-9]+ volume_tests=[0-9]+ leaves=[0-9]+ candidates=1 "
                                       "touched=2\n"));
    EXPECT_EQ(collide("2x2", square_, "0,0,0,0.1").out, "0\n");
    EXPECT_EQ(collide("2x2", square_, "1,0,1,0.1").out, "1\n");
    EXPECT_EQ(collide("2x2", square_, "0.25,1,0.25,1").out, "0\n") << "just touching counts";
    const LabRun none = collide("2x2", square_, "0,5,0,0.1");
    EXPECT_THAT(none.out, IsEmpty());
    EXPECT_EQ(none.code, 0);
}

TEST_F(LabCollideInput, MayHaveBlanksAndCarriageReturns) {
    EXPECT_EQ(collide("2x2", "0, 0,\t0\r\n1,0,0\r\n0 ,0,1\r\n1,0,1", "0,0,0, 0.1").out, "0\n");
}

TEST_F(LabCollideInput, ErrorsNameFileAndLine) {
    const std::vector<std::pair<std::string, std::string>> bad{{"0,0,0\n1,0\n0,0,1\n1,0,1\n", "x.csv:2: "},
                                                               {"0,0,0\n1,0,0,0\n0,0,1\n1,0,1\n", "x.csv:2: "},
                                                               {"0,0,0\n1,0,0\nnan,0,1\n1,0,1\n", "x.csv:3: "},
                                                               {"0,0,0\n1,0,0\n0,inf,1\n1,0,1\n", "x.csv:3: "},
                                                               {"x,y,z\n" + square_, "x.csv:1: "},
                                                               {square_ + "1,1,1\n", "x.csv:5: "},
                                                               {"0,0,0\n1,0,0\n\n0,0,1\n1,0,1\n", "x.csv:3: "},
                                                               {"0,0,0\n1,0,0\n0,0,1\n", "x.csv: 3 rows"},
                                                               {"", "x.csv: 0 rows"},
                                                               {std::string(100'000, '1') + "\n", "x.csv:1: "},
                                                               {"0;0;0\n", "x.csv:1: "},
                                                               {std::string(10, '\0'), "x.csv:1: "},
                                                               {"1e99,0,0\n", "x.csv:1: "}};
    for (const auto& [text, place] : bad) {
        const LabRun run = collide("2x2", text, "0,0,0,1");
        EXPECT_EQ(run.code, 2) << place;
        EXPECT_THAT(run.err, StartsWith("drape-lab: " + place));
        EXPECT_LT(run.err.size(), 400u);
        EXPECT_THAT(run.out, IsEmpty());
    }
}

TEST_F(LabCollideInput, ErrorsNameTheOption) {
    for (const char* grid : {"", "2", "x", "2x", "x2", "1x2", "2x1", "0x0", "-2x2", "2x2x2", "2.5x2", "4097x2", "2X2",
                             "99999999999999999999x2"}) {
        const LabRun run = collide(grid, square_, "0,0,0,1");
        EXPECT_EQ(run.code, 2) << grid;
        EXPECT_THAT(run.err, HasSubstr("--grid")) << grid;
    }
    for (const char* ball : {"", "0,0,0", "0,0,0,1,2", "0,0,0,-1", "0,0,0,nan", "inf,0,0,1", "a,0,0,1", "0,0,0,1,"}) {
        const LabRun run = collide("2x2", square_, ball);
        EXPECT_EQ(run.code, 2) << ball;
        EXPECT_THAT(run.err, HasSubstr("--ball")) << ball;
    }
    const LabRun missing = folder_.run({"collide", "--grid", "2x2", "--positions", "none.csv", "--ball", "0,0,0,1"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_THAT(missing.err, HasSubstr("none.csv"));
    folder_.write("x.csv", square_);
    const LabRun method =
        folder_.run({"collide", "--grid", "2x2", "--positions", "x.csv", "--ball", "0,0,0,1", "--set", "volume=cube"});
    EXPECT_EQ(method.code, 2);
    EXPECT_THAT(method.err, AllOf(HasSubstr("--set volume=cube"), HasSubstr("'sphere'")));
}

}  // namespace
}  // namespace drape
