#include <gmock/gmock.h>

#include <sstream>

#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;

using Cells = std::vector<std::string>;

/// The cells of an experiment's rows without those of the names.
std::vector<Cells> cells_of(const std::string& experiment, const std::string& cases) {
    const LabFolder folder;
    const LabRun run = folder.run({experiment, "--quick", "--cases", cases, "--out", "out"});
    EXPECT_EQ(run.code, 0) << run.err;
    std::vector<Cells> rows;
    for (const std::string& row : table_of(folder, "out/" + experiment + ".csv")) {
        std::istringstream line(row);
        Cells& cells = rows.emplace_back();
        for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
    }
    rows.erase(rows.begin());
    return rows;
}

TEST(LabSolve, LeavesLessToACloserToleranceAndFarLessThanTheStep) {
    const std::vector<Cells> rows = cells_of("solve", "1-1");
    ASSERT_EQ(rows.size(), 7u);
    double before = 1;
    for (const Cells& row : rows) {
        const double tolerance = std::stod(row.at(6)), left = std::stod(row.at(8)), of_step = std::stod(row.at(9));
        EXPECT_LT(left, before / 2) << tolerance;
        if (tolerance <= 1e-4) {
            EXPECT_LT(left, of_step / 200) << tolerance;
        }
        before = left;
    }
}

/// Small sheets are moved in real time by an explicit method, and are near the converged one; five passes of XPBD a
/// frame leave the springs too long.
TEST(LabRealtime, SaysWhichClothsAreInTimeAndWhichAreStretched) {
    const std::vector<Cells> in_time = cells_of("realtime", "1-1"), stretched = cells_of("realtime", "10-10");
    ASSERT_EQ(in_time.size(), 3u);
    for (const Cells& row : in_time) {
        EXPECT_EQ(row.at(2), "symplectic_euler_by_1");
        EXPECT_EQ(row.at(9), "realtime") << row.at(4);
        EXPECT_LT(std::stod(row.at(8)), 0.02) << row.at(4);
    }
    for (const Cells& row : stretched) {
        EXPECT_EQ(row.at(2), "xpbd_1_by_5");
        EXPECT_EQ(row.at(9), "stretched") << row.at(4);
    }
}

}  // namespace
}  // namespace drape
