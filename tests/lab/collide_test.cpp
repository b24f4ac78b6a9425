#include <gmock/gmock.h>

#include <random>

#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"
#include "lab/lab_run.h"
#include "support/cloths.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
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

TEST(LongLabCollide, FindsWhatMeasuringEveryTriangleFindsWithEveryVolumeFitUpdateAndLeafSize) {
    std::vector<std::vector<std::string>> methods;
    for (const std::string& update : find_setting("contact.update").choices) {
        for (const std::string& volume : find_setting("contact.volume").choices) {
            methods.push_back({"update=" + update, "volume=" + volume});
        }
        for (const std::string& fit : find_setting("contact.sphere_fit").choices) {
            methods.push_back({"update=" + update, "sphere_fit=" + fit});
        }
    }
    const LabFolder folder;
    std::mt19937 random(17);
    std::uniform_real_distribution<double> place(-0.7, 0.7), size(0.01, 0.5);
    std::size_t touched = 0;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const Grid grid{2 + static_cast<int>(random() % 30), 2 + static_cast<int>(random() % 30)};
        const Points x = test::random_cloth(grid, random);
        Ball ball{.centre = {place(random), place(random) / 4, place(random)}, .radius = size(random)};
        if (i % 4 == 0) {
            // Just touching one triangle's corner, or just not
            const Vec3 corner = x.row(static_cast<int>(random() % static_cast<unsigned>(grid.particles()))).transpose();
            ball.radius = (corner - ball.centre).norm() * (i % 8 == 0 ? 1 + 1e-12 : 1 - 1e-12);
        }
        const std::string expected = touched_one_by_one(grid, x, ball);
        touched += expected.size();
        folder.write("x.csv", csv_of(x));
        std::vector<std::string> words{"collide",       "--grid", grid_text(grid),
                                       "--positions",   "x.csv",  "--ball",
                                       ball_text(ball), "--set",  "leaf_cells=" + std::to_string(1 + i % 9)};
        words.insert(words.end(), methods[i].begin(), methods[i].end());
        const LabRun run = folder.run(words);
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run.out, expected) << testing::PrintToString(words);
    }
    EXPECT_GT(touched, 5'000u);
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
    EXPECT_EQ(collide("2x2", "0, 0,\t0\r\n1,0,0\r\n0 ,0,1\r\n1,0,1", "0,0,0, 0.1").out, "0\n") << "blanks";
    const LabRun none = collide("2x2", square_, "0,5,0,0.1");
    EXPECT_THAT(none.out, IsEmpty());
    EXPECT_EQ(none.code, 0);
}

TEST_F(LabCollideInput, ErrorsNameFileAndLine) {
    const std::vector<std::pair<std::string, std::string>> bad{{"0,0,0\n1,0\n0,0,1\n1,0,1\n", "x.csv:2: "},
                                                               {"0,0,0\n1,0,0,0\n0,0,1\n1,0,1\n", "x.csv:2: "},
                                                               {"0,0,0\n1,0,0\nnan,0,1\n1,0,1\n", "x.csv:3: "},
                                                               {"0,0,0\n1,0,0\n0,inf,1\n1,0,1\n", "x.csv:3: "},
                                                               {square_ + "1,1,1\n", "x.csv:5: "},
                                                               {"0,0,0\n1,0,0\n\n0,0,1\n1,0,1\n", "x.csv:3: "},
                                                               {"0,0,0\n1,0,0\n0,0,1\n", "x.csv: 3 rows"},
                                                               {"", "x.csv: 0 rows"},
                                                               {std::string(100'000, '1') + "\n", "x.csv:1: "},
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
    for (const char* grid : {"", "2x", "1x2", "-2x2", "2x2x2", "2.5x2", "4097x2", "99999999999999999999x2"}) {
        const LabRun run = collide(grid, square_, "0,0,0,1");
        EXPECT_EQ(run.code, 2) << grid;
        EXPECT_THAT(run.err, HasSubstr("--grid")) << grid;
    }
    for (const char* ball : {"", "0,0,0", "0,0,0,1,2", "0,0,0,-1", "0,0,0,nan", "a,0,0,1"}) {
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
