#include "drape/base/memory_limit.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/scratch_folder.h"

namespace drape {
namespace {

TEST(MemoryLimit, IsAtMostWhatTheMachineHas) {
    const MemoryLimit limit = memory_limit();
    EXPECT_GT(limit.bytes, 1e6);
    EXPECT_LT(limit.bytes, 1e15);
    EXPECT_FALSE(limit.whose.empty());
}

TEST(MemoryLimit, IsTheLeastOfTheControlGroupsAboveAProcess) {
    const ScratchFolder folder;
    const auto put = [&](const std::string& file, const std::string& text) {
        std::filesystem::create_directories((folder.path() / file).parent_path());
        std::ofstream(folder.path() / file) << text << "\n";
    };
    const auto limit = [&](const std::string& groups) {
        put("groups", groups);
        return control_group_limit(folder.path() / "groups", folder.path() / "mounted");
    };
    put("mounted/memory.max", "9000");
    put("mounted/a/memory.max", "max");
    put("mounted/a/b/memory.max", "7000");
    put("mounted/memory/c/memory.limit_in_bytes", "5000");
    put("mounted/memory/c/d/memory.limit_in_bytes", "9223372036854771712");
    EXPECT_EQ(limit("0::/a/b"), 7000) << "version 2";
    EXPECT_EQ(limit("0::/a"), 9000) << "that of the group above";
    EXPECT_EQ(limit("0::/no/such"), 9000) << "a container's own groups";
    EXPECT_EQ(limit("2:cpu:/x\n4:cpuset,memory:/c/d\n0::/a"), 5000) << "version 1";
    EXPECT_EQ(limit("2:cpu:/c"), std::nullopt);
    EXPECT_EQ(limit("nothing"), std::nullopt);
}

TEST(MemoryLimit, HasTextsOfTwoOrThreeDigits) {
    EXPECT_EQ(bytes_text(0), "0 MB");
    EXPECT_EQ(bytes_text(54.34e6), "54.3 MB");
    EXPECT_EQ(bytes_text(999e6), "999 MB");
    EXPECT_EQ(bytes_text(3.14159e9), "3.14 GB");
}

}  // namespace
}  // namespace drape
