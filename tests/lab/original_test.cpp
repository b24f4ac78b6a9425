// The experiment "original" on the dissertation's five tests: cases of it run as a program.

#include <gmock/gmock.h>

#include <filesystem>

#include "drape/base/resources.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using ::testing::HasSubstr;
using ::testing::Not;

/// Runs a copy of the laboratory: beside it there is no `drape-capture` but what a test has put there.
LabRun run_alone(const LabFolder& folder, const std::string& cases) {
    std::filesystem::copy_file(DRAPE_LAB, folder.path() / "drape-lab");
    const std::string data = find_resource("scenes/original.toml").parent_path().parent_path().string();
    return folder.run({"original", "--quick", "--cases", cases, "--out", "out"}, (folder.path() / "drape-lab").string(),
                      {{"DRAPE_DATA", data}});
}

TEST(LongLabOriginal, HasEveryCellWhereThereIsAProgramToDraw) {
    const Rows rows = original_experiment().cases(true)[0]();
    ASSERT_EQ(rows.size(), 4u);
    for (const Row& row : rows) {
        EXPECT_GT(row.number("execution_s"), 0);
        EXPECT_GT(row.number("gl_calls"), 5);
        EXPECT_GT(row.number("rate_per_s"), 0);
        EXPECT_GT(row.number("cpu"), 0);
        EXPECT_GT(row.number("single_search_s"), 0);
    }
    // Bounds are in the picture where the table says so, and more vertices for spheres than for boxes
    const auto vertices = [&rows](std::size_t k) { return rows[k].number("vertices"); };
    EXPECT_EQ(vertices(0), vertices(1));
    EXPECT_GT(vertices(2), vertices(0));
    EXPECT_GT(vertices(3), vertices(0));
    EXPECT_GT(vertices(2), vertices(3));
}

TEST(LongLabOriginal, FailsWhereTheProgramThatDrawsFailsOrWritesNothing) {
    const std::pair<const char*, const char*> failures[]{{"/bin/false", "drape-capture failed on the scene original"},
                                                         {"/bin/true", "has too few rows"}};
    for (const auto& [program, said] : failures) {
        const LabFolder folder;
        std::filesystem::create_symlink(program, folder.path("drape-capture"));
        const LabRun run = run_alone(folder, "1-1");
        EXPECT_EQ(run.code, 1) << program;
        EXPECT_THAT(run.err, HasSubstr(said));
    }
}

TEST(LongLabOriginal, LeavesCellsEmptyAndSaysSoWithoutAProgramToDraw) {
    const LabFolder folder;
    const LabRun run = run_alone(folder, "1-2");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string line = "There is no " + (folder.path() / "drape-capture").string();
    ASSERT_THAT(run.err, HasSubstr(line));
    EXPECT_THAT(run.err.substr(run.err.find(line) + 1), Not(HasSubstr(line))) << "once, not in every case";
    const auto rows = table_of(folder, "out/original.csv");
    ASSERT_EQ(rows.size(), 9u) << "a header and four ways in two cases";
    for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_THAT(rows[k], HasSubstr(",,,,,"));
}

}  // namespace
}  // namespace drape
