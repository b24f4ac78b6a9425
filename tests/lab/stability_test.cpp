#include <gmock/gmock.h>

#include <algorithm>

#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::ContainsRegex;
using testing::HasSubstr;

// A share of a single case is enough to see what is written
TEST(LabStability, WritesATableThatSaysWhereItIsFromAndAgreesWithThePrediction) {
    const LabFolder folder;
    const LabRun run = folder.run({"stability", "--quick", "--share", "2/500", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string text = folder.read("out/stability.csv");
    for (const char* part :
         {"# machine: ", "# compiler: ", "# drape: ", "# commit: ", "# date: ", "# settings: --quick --share 2/500"}) {
        EXPECT_THAT(text, HasSubstr(part));
    }
    const auto lines = table_of(folder, "out/stability.csv");
    ASSERT_GT(lines.size(), 10u);
    EXPECT_THAT(lines[0], testing::StartsWith("case,method,sweep,side,stiffness_N_per_m,damping_N_s_per_m,"));
    for (const auto& line : lines) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(lines[0].begin(), lines[0].end(), ',')) << line;
        EXPECT_FALSE(line.ends_with(",disagrees")) << line;
    }
    EXPECT_THAT(text, HasSubstr(",bounded,agrees"));
    EXPECT_THAT(text, HasSubstr(",energy_rose,agrees"));
    EXPECT_THAT(run.out,
                ContainsRegex("explicit_euler: 20 trials, [0-9]+ close to the limit, 0 against the prediction"));
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/stability_explicit_euler.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(folder.read("out/stability_explicit_euler.png"), testing::StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace drape
