#include <gmock/gmock.h>

#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using testing::HasSubstr;

// A share of a single case is enough to see what is written
TEST(LabStability, WritesATableThatSaysWhereItIsFromAndAgreesWithThePrediction) {
    const LabFolder folder;
    const LabRun run = folder.run({"stability", "--quick", "--share", "2/500", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string text = folder.read("out/stability.csv");
    EXPECT_THAT(text, HasSubstr("# settings: --quick --share 2/500"));
    EXPECT_THAT(text, HasSubstr(",bounded,agrees"));
    EXPECT_THAT(text, HasSubstr(",energy_rose,agrees"));
    EXPECT_THAT(text, testing::Not(HasSubstr(",disagrees")));
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/stability_explicit_euler.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(folder.read("out/stability_explicit_euler.png"), testing::StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace drape
