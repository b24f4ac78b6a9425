#include <gmock/gmock.h>

#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
using test::table_of;
using test::values_of;
using testing::HasSubstr;

TEST(LabSimulate, PlaysARecordingAndSaysIfItDiffers) {
    const LabFolder folder;
    const std::string head = "drape-recording 1\nscene drop\nset cloth.mass=0.3\n";
    folder.write("good.txt", head + "100 set wind.on=true\n200 end\n");
    folder.write("differs.txt", head + "100 set wind.on=true\n150 hash 0123456789abcdef\n200 end\n");
    folder.write("cut.txt", head + "100 set wind.on=true\n150 ha");
    const LabRun good = folder.run({"simulate", "--time", "0.05", "--replay", "good.txt", "--hash"});
    EXPECT_EQ(good.code, 0);
    EXPECT_EQ(lines_of(good.err).size(), 1u);
    const LabRun differs = folder.run({"simulate", "--time", "0.05", "--replay", "differs.txt", "--hash"});
    EXPECT_THAT(differs.err, HasSubstr("before step 150"));
    EXPECT_EQ(differs.code, 1);
    EXPECT_EQ(differs.out, good.out);
    const LabRun cut = folder.run({"simulate", "--time", "0.05", "--replay", "cut.txt", "--hash"});
    EXPECT_THAT(cut.err, HasSubstr("cut.txt:5: cut off"));
    EXPECT_EQ(cut.out, good.out);
    EXPECT_NE(folder.run({"simulate", "drop", "--set", "cloth.mass=0.3", "--time", "0.05", "--hash"}).out, good.out);
}

TEST(LabSimulate, PlaysAWholeRecordingOrToItsLastWholeCommandWhereNoTimeIsGiven) {
    const LabFolder folder;
    const std::string text = "drape-recording 1\nscene drop\n0 set dt=1e-4\n100 set dt=2e-4\n";
    folder.write("longer.txt", text + "150 end\n");
    folder.write("whole.txt", text + "100 end\n");
    folder.write("cut.txt", text + "9999 ste");
    folder.write("endless.txt", text + "9223372036854775807 end\n");
    const LabRun longer = folder.run({"simulate", "--replay", "longer.txt", "--hash", "--stats", "stats.csv"});
    ASSERT_EQ(longer.code, 0) << longer.err;
    EXPECT_DOUBLE_EQ(values_of(table_of(folder, "stats.csv")[1])[1], 0.02);
    EXPECT_EQ(longer.out, folder.run({"simulate", "--replay", "cut.txt", "--time", "0.02", "--hash"}).out);
    const std::string hash = folder.run({"simulate", "--replay", "whole.txt", "--hash"}).out;
    for (const char* file : {"cut.txt", "endless.txt"}) {
        const LabRun cut = folder.run({"simulate", "--replay", file, "--hash"});
        EXPECT_EQ(cut.code, 0) << file;
        EXPECT_EQ(cut.out, hash) << file;
        EXPECT_THAT(cut.err, HasSubstr(std::string(file) + ":5: ")) << file;
        EXPECT_THAT(cut.err, HasSubstr("100 steps to 0.01 s")) << file;
    }
}

TEST(LabSimulate, BlamesTheRecordingForItsSettings) {
    const LabFolder folder;
    const std::string head = "drape-recording 1\nscene drop\nset cloth.mass=0.3\n";
    folder.write("unknown.txt", head + "set solver.dtx=1\n0 end\n");
    folder.write("misfit.txt", head + "set ball.motion=path\n0 end\n");
    folder.write("good.txt", head + "0 end\n");
    const auto complaint = [&](const std::string& file, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"simulate", "--replay", file};
        words.insert(words.end(), more.begin(), more.end());
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << file;
        return run.err;
    };
    EXPECT_THAT(complaint("unknown.txt"),
                testing::StartsWith("drape-lab: unknown.txt:4: unknown setting 'solver.dtx'"));
    EXPECT_THAT(complaint("misfit.txt"), testing::StartsWith("drape-lab: misfit.txt: ball.motion = path"));
    EXPECT_THAT(complaint("misfit.txt", {"--set", "dt=1e-4"}), testing::StartsWith("drape-lab: misfit.txt: ball."));
    EXPECT_THAT(complaint("good.txt", {"--set", "ball.motion=path"}), HasSubstr("--set: ball.motion = path"));
    EXPECT_THAT(complaint("good.txt", {"--set", "dtx=1"}), HasSubstr("--set dtx=1: unknown setting"));
    EXPECT_EQ(folder.run({"simulate", "--replay", "misfit.txt", "--set", "ball.motion=still"}).code, 0);
}

TEST(LabSimulate, FailsWhereAReplayRefusesACommand) {
    const LabFolder folder;
    folder.write("refused.txt", "drape-recording 1\nscene drop\n3 grab 0 899\n5 end\n");
    EXPECT_EQ(folder.run({"simulate", "--replay", "refused.txt"}).code, 0);
    const LabRun run = folder.run({"simulate", "--replay", "refused.txt", "--set", "cloth.particles=9,9"});
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("refused.txt:3: 'grab 0 899' is refused: grab: particle 899: allowed 0 to 80"));
}

}  // namespace
}  // namespace drape
