// The experiment "original" on the dissertation's five tests: its parts, and a case of it run as a program.

#include <gmock/gmock.h>

#include <filesystem>

#include "drape/base/input_error.h"
#include "drape/base/resources.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"
#include "lab/original/original.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr OriginalPlan tiny{.first = 2, .frames = 2, .passes = 1};

TEST(OriginalConclusion, JudgesBothHalvesOfTheConclusionApart) {
    const auto conclusion = [](double sphere_build, double aabb_build, double sphere_search, double aabb_search) {
        return original_conclusion({.build = sphere_build, .search = sphere_search},
                                   {.build = aabb_build, .search = aabb_search});
    };
    EXPECT_THAT(conclusion(8e-6, 4e-6, 2e-6, 1e-6), AllOf(HasSubstr("build holds"), HasSubstr("search does not hold")));
    EXPECT_THAT(conclusion(4e-6, 8e-6, 1e-6, 2e-6), AllOf(HasSubstr("build does not hold"), HasSubstr("search holds")));
    EXPECT_THAT(conclusion(4e-6, 4.1e-6, 2e-6, 1.99e-6),
                AllOf(HasSubstr("build is too close to tell"), HasSubstr("search is too close to tell")));
}

TEST(OriginalSummary, TakesTheConclusionFromTheMediansOfTheTable) {
    // Spheres more expensive and faster; in the tree down to single cells, cheaper and slower. One row of five is far
    // off
    std::vector<TableRow> rows;
    for (int k = 0; k < 5; ++k) {
        const std::string build = k == 2 ? "9e-3" : "4e-6";
        rows.push_back({"sphere", "0", "0.004", "0.004", "0.004", "20", "25", "0.5", "40000", "8e-6", "1e-6", "1e-6",
                        "9", "8e-6", "2e-6", "1e-6", "9"});
        rows.push_back({"aabb", "0", "0.003", "0.003", "0.003", "30", "25", "0.5", "40000", build, "2e-6", "1e-6", "9",
                        "9e-6", "1e-6", "1e-6", "9"});
    }
    const std::string text = original_experiment().summary(rows);
    EXPECT_THAT(
        text, HasSubstr("scene has: the dissertation's conclusion that spheres are more expensive to build holds (8 us "
                        "against 4 us"));
    EXPECT_THAT(text, HasSubstr("faster to search holds (1 us against 2 us"));
    EXPECT_THAT(
        text, HasSubstr("single cells: the dissertation's conclusion that spheres are more expensive to build does not "
                        "hold (8 us against 9 us"));
    EXPECT_THAT(text, HasSubstr("faster to search does not hold (2 us against 1 us"));
    for (const char* published : {"235.258", " 22\n", "15000", " 34\n", "42000"})
        EXPECT_THAT(text, HasSubstr(published));
}

TEST(LongOriginalRows, HaveEveryCellWhereThereIsAProgramToDraw) {
    bool draws = false;
    const auto rows = original_rows(tiny, program_folder() / "drape-capture", draws);
    EXPECT_TRUE(draws);
    ASSERT_EQ(rows.size(), 4u);
    for (const OriginalRow& row : rows) {
        EXPECT_GT(row.execution.median, 0);
        EXPECT_GT(row.gl_calls, 5);
        EXPECT_GT(row.rate, 0);
        EXPECT_GT(row.cpu, 0);
        EXPECT_GT(row.single.search, 0);
    }
    // Bounds are in the picture where the table says so, and more vertices for spheres than for boxes
    const auto vertices = [&rows](std::size_t k) { return rows[k].vertices; };
    EXPECT_EQ(vertices(0), vertices(1));
    EXPECT_GT(vertices(2), vertices(0));
    EXPECT_GT(vertices(3), vertices(0));
    EXPECT_GT(vertices(2), vertices(3));
}

TEST(OriginalRows, FailWhereTheProgramFails) {
    OriginalRow row;
    EXPECT_THROW((void)draw_original({"sphere", false}, tiny, "/bin/false", row), RunError);
    EXPECT_THROW((void)draw_original({"sphere", false}, tiny, "/bin/true", row), RunError) << "where it writes nothing";
}

TEST(LongLabOriginal, LeavesCellsEmptyAndSaysSoWithoutAProgramToDraw) {
    const LabFolder folder;
    std::filesystem::copy_file(DRAPE_LAB, folder.path() / "drape-lab");
    const std::string data = find_resource("scenes/original.toml").parent_path().parent_path().string();
    const LabRun run = folder.run({"original", "--quick", "--cases", "1-2", "--out", "out"},
                                  (folder.path() / "drape-lab").string(), {{"DRAPE_DATA", data}});
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string line = "There is no " + (folder.path() / "drape-capture").string();
    ASSERT_THAT(run.err, HasSubstr(line));
    EXPECT_THAT(run.err.substr(run.err.find(line) + 1), Not(HasSubstr(line))) << "once, not in every case";
    const auto rows = table_of(folder, "out/original.csv");
    ASSERT_EQ(rows.size(), 9u) << "a header and four ways in two cases";
    for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_THAT(rows[k], HasSubstr(",,,,,"));
    EXPECT_THAT(run.out, HasSubstr("frame rate [1/s]                -             -"));
    EXPECT_THAT(run.out, HasSubstr("more expensive to build "));
}

}  // namespace
}  // namespace drape
