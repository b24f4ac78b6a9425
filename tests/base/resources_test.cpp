#include "drape/base/resources.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "support/input_errors.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

TEST(Resources, LieBesideTheProgramsFolder) {
    unsetenv("DRAPE_DATA");
    EXPECT_EQ(find_resource("scenes"), program_folder().parent_path() / "share" / "drape" / "scenes");
}

TEST(Resources, LieInTheFolderThatDrapeDataNames) {
    const test::ScratchFolder scratch;
    const fs::path& folder = scratch.path();
    std::ofstream(folder / "mine.toml") << "[cloth]\n";
    setenv("DRAPE_DATA", folder.c_str(), 1);
    EXPECT_EQ(find_resource("mine.toml"), folder / "mine.toml");
    EXPECT_THAT(test::run_error_of([] { find_resource("no_such.toml"); }),
                testing::AllOf(testing::HasSubstr(folder.string()), testing::HasSubstr("no_such")));
    unsetenv("DRAPE_DATA");
}

}  // namespace
}  // namespace drape
