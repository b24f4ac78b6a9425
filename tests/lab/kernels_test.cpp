#include <gmock/gmock.h>

#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::HasSubstr;

TEST(LabKernels, TimesEachStageByBothKindsOfKernels) {
    const LabFolder folder;
    const LabRun run = folder.run({"kernels", "--quick", "--cases", "1-1", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = table_of(folder, "out/kernels.csv");
    ASSERT_EQ(rows.size(), 9u) << "a header, and four stages by two kinds";
    for (const char* stage : {"step", "build", "query", "narrow_phase"}) {
        EXPECT_THAT(rows, testing::Contains(HasSubstr(std::string(",") + stage + ",vector,256,")));
        EXPECT_THAT(rows, testing::Contains(HasSubstr(std::string(",") + stage + ",plain,256,")));
        EXPECT_THAT(run.out, HasSubstr(std::string(stage) + ", particles 256, plain: 1 row, time_s "));
    }
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/kernels.svg"), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace drape
