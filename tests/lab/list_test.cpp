#include <gmock/gmock.h>

#include "drape/integrate/integrator.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
using testing::HasSubstr;

std::vector<std::string> listed_by_lab(const std::string& what) {
    const LabFolder folder;
    const LabRun run = folder.run({"list", what});
    EXPECT_EQ(run.code, 0) << run.err;
    return lines_of(run.out);
}

TEST(LabList, PrintsEachSceneWithItsTitle) {
    std::vector<std::string> expected;
    for (const std::string& name : scene_names()) expected.push_back(name + ": " + load_scene(name).title);
    EXPECT_EQ(listed_by_lab("scenes"), expected);
}

TEST(LabList, PrintsTheNamesThatSettingsTake) {
    EXPECT_EQ(listed_by_lab("integrators"), find_setting("solver.integrator").choices);
    EXPECT_EQ(listed_by_lab("volumes"), find_setting("contact.volume").choices);
    EXPECT_EQ(listed_by_lab("updates"), find_setting("contact.update").choices);
    EXPECT_EQ(listed_by_lab("fits"), find_setting("contact.sphere_fit").choices);
    EXPECT_EQ(listed_by_lab("settings").size(), setting_table().size());
    EXPECT_THAT(listed_by_lab("experiments"), testing::Contains(testing::StartsWith("stability: ")));
}

TEST(LabHelp, NeedsNoData) {
    const LabFolder folder;
    std::filesystem::copy(DRAPE_LAB, folder.path() / "drape-lab");
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--help"}, {"simulate", "--help"}}) {
        const LabRun run = folder.run(words, folder.path() / "drape-lab");
        EXPECT_EQ(run.code, 0) << run.err;
    }
}

TEST(LabList, NamesWhatItCanList) {
    const LabFolder folder;
    const LabRun run = folder.run({"list", "scene"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("scenes"));
    EXPECT_EQ(folder.run({"list"}).code, 2);
}

}  // namespace
}  // namespace drape
