#include "drape/base/resources.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "drape/base/input_error.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

/// A data folder of its own, named by DRAPE_DATA while the test runs.
class GivenDataFolder : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(folder_ / "scenes");
        std::ofstream(folder_ / "scenes" / "mine.toml") << "[cloth]\n";
        setenv("DRAPE_DATA", folder_.c_str(), 1);
    }
    void TearDown() override { unsetenv("DRAPE_DATA"); }
    test::ScratchFolder scratch_;
    const fs::path& folder_ = scratch_.path();
};

TEST(Resources, LieBesideTheProgramsFolder) {
    unsetenv("DRAPE_DATA");
    EXPECT_EQ(find_resource("scenes"), program_folder().parent_path() / "share" / "drape" / "scenes");
}

TEST_F(GivenDataFolder, IsSearched) { EXPECT_EQ(find_resource("scenes/mine.toml"), folder_ / "scenes/mine.toml"); }

TEST_F(GivenDataFolder, IsNamedWhereAFileIsMissing) {
    try {
        find_resource("scenes/no_such.toml");
        FAIL() << "found a file that is not there";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(folder_.string()));
        EXPECT_THAT(error.what(), testing::HasSubstr("no_such.toml"));
    }
}

}  // namespace
}  // namespace drape
