#include "drape/base/named_file.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "support/input_errors.h"

namespace drape {
namespace {

namespace fs = std::filesystem;
using test::input_error_of;

constexpr auto to_read = NamedFile::Use::Read;

class NamedFiles : public testing::Test {
protected:
    NamedFiles() {
        fs::create_directories(folder_ / "inner");
        std::ofstream(folder_ / "there") << "text";
        fs::create_hard_link(folder_ / "there", folder_ / "hard");
        fs::create_symlink("there", folder_ / "soft");
        fs::create_symlink("to-come", folder_ / "dangling");
        fs::create_symlink(".", folder_ / "round");
    }
    ~NamedFiles() override { fs::remove_all(folder_); }

    /// What is said of two files that are written.
    [[nodiscard]] std::string refusal(const std::string& one, const std::string& other) const {
        return input_error_of([&] {
            check_apart({{"--state", folder_ / one}, {"--none", ""}, {"--stats", folder_ / other}});
        });
    }

    const fs::path folder_ = fs::path(testing::TempDir()) / ("drape-named-" + std::to_string(getpid()));
};

TEST_F(NamedFiles, ThatAreOneAreRefusedWhateverTheyAreCalled) {
    for (const auto& [one, other] : std::vector<std::pair<std::string, std::string>>{{"there", "there"},
                                                                                     {"there", "./there"},
                                                                                     {"there", "inner/../there"},
                                                                                     {"there", "soft"},
                                                                                     {"soft", "hard"},
                                                                                     {"there", "round/there"},
                                                                                     {"new", "new"},
                                                                                     {"new", "./new"},
                                                                                     {"new", "inner/../new"},
                                                                                     {"round/new", "new"},
                                                                                     {"dangling", "to-come"},
                                                                                     {"no/folder", "no/./folder"}}) {
        const std::string said = refusal(one, other);
        EXPECT_THAT(said, testing::StartsWith("--state ")) << one << " and " << other;
        EXPECT_THAT(said, testing::HasSubstr(" and --stats ")) << one << " and " << other;
    }
    for (const char* other : {"other", "inner/there", "THERE", "inner/new"}) {
        EXPECT_NO_THROW(check_apart({{"--state", folder_ / "there"}, {"--stats", folder_ / other}})) << other;
    }
}

TEST_F(NamedFiles, MayBeReadTwiceButNotReadAndWritten) {
    const fs::path file = folder_ / "there";
    EXPECT_NO_THROW(check_apart({{"SCENE", file, to_read}, {"--replay", file, to_read}}));
    EXPECT_THROW(check_apart({{"SCENE", file, to_read}, {"--record", folder_ / "soft"}}), InputError);
    EXPECT_THROW(check_apart({{"--record", folder_ / "soft"}, {"SCENE", file, to_read}}), InputError);
}

TEST_F(NamedFiles, MayBeOneDevice) {
    EXPECT_NO_THROW(check_apart({{"--state", "/dev/null"}, {"--stats", "/dev/null"}}));
}

}  // namespace
}  // namespace drape
