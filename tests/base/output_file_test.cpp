#include "drape/base/output_file.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "support/process.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

TEST(OutputFile, HasAllThatWasWrittenOnceItIsClosed) {
    const fs::path path = fs::path(testing::TempDir()) / "drape_output_file_test.txt";
    OutputFile file(path.string());
    ASSERT_TRUE(file.wanted());
    file.stream() << "a line\n";
    file.close();
    EXPECT_EQ(testing_aid::read_file(path), "a line\n");
    fs::remove(path);
}

TEST(OutputFile, WithoutANameTakesNothing) {
    OutputFile file("");
    EXPECT_FALSE(file.wanted());
    EXPECT_NO_THROW(file.close());
}

TEST(OutputFile, ThatCannotBeWrittenIsNamedBeforeAnyWork) {
    try {
        OutputFile file("/no/such/folder/state.csv");
        FAIL() << "opened a file in a folder that is not there";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("/no/such/folder/state.csv"));
    }
}

TEST(OutputFile, OnAFullDiskIsNamedWhenItIsClosed) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no device that is always full";
    OutputFile file("/dev/full");
    file.stream() << "a line\n";
    EXPECT_THROW(file.close(), RunError);
}

}  // namespace
}  // namespace drape
