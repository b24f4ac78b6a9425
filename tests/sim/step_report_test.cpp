#include "drape/sim/step_report.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/small_scene.h"

namespace drape {
namespace {

TEST(ReportFields, HaveNamesOfTheirOwnAndUnitsThatThePanelKnows) {
    const std::set<std::string_view> units{"", "1", "s", "us", "m", "m/s", "J"};
    std::set<std::string_view> names, labels;
    for (const ReportField& field : report_fields()) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
        EXPECT_TRUE(units.contains(field.unit)) << field.name;
        if (field.label.empty()) continue;
        EXPECT_TRUE(labels.insert(field.label).second) << field.label;
        EXPECT_LE(field.label.size(), 15u) << field.label << " runs into its value";
        EXPECT_GE(field.importance, 1) << field.label;
    }
}

TEST(ReportFields, AreNeverMoreThanTheirWhole) {
    Simulation simulation = small_simulation({"search_tests=9", "leaf_cells=1"});
    int parts = 0;
    for (int step = 0; step < 1000; ++step) {
        simulation.step();
        for (const ReportField& field : report_fields()) {
            if (field.whole == nullptr) continue;
            ++parts;
            EXPECT_LE(field.read(simulation.report()), field.whole(simulation.report())) << field.name;
        }
    }
    EXPECT_GT(parts, 5000);
}

}  // namespace
}  // namespace drape
