#include "../../src/app/window_size.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/process.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

std::string kept(const PictureSize& screen = {1280, 1024}) {
    const auto size = kept_window_size(screen);
    return size ? size_text(*size) : "none";
}

struct WindowSize : testing::Test {
    WindowSize() { setenv("XDG_STATE_HOME", folder_.path().c_str(), 1); }
    ~WindowSize() override {
        for (const auto& [name, value] : before_) value ? setenv(name, value->c_str(), 1) : unsetenv(name);
    }

    static std::pair<const char*, std::optional<std::string>> variable(const char* name) {
        const char* const value = std::getenv(name);
        return {name, value == nullptr ? std::nullopt : std::optional<std::string>(value)};
    }

    const std::pair<const char*, std::optional<std::string>> before_[2] = {variable("XDG_STATE_HOME"),
                                                                           variable("HOME")};
    const ScratchFolder folder_;
};

TEST_F(WindowSize, IsThatOfTheLastTimeAsFarAsThereIsRoom) {
    EXPECT_EQ(kept(), "none");
    keep_window_size({900, 500});
    EXPECT_EQ(kept(), "900x500");
    EXPECT_EQ(kept({800, 400}), "800x400");
    keep_window_size({1, 1});
    EXPECT_EQ(kept(), "320x180") << "one that could not be found again";
    EXPECT_EQ(test::names_in(folder_.path() / "drape"), std::vector<std::string>{"window"});
    keep_window_size({9000, 500});
    EXPECT_EQ(kept({10000, 1024}), "none") << "wider than any that can be asked for";
    setenv("XDG_STATE_HOME", "here", 1);
    setenv("HOME", "/home/someone", 1);
    EXPECT_EQ(window_size_file(), fs::path("/home/someone") / ".local/state/drape/window") << "not a relative one";
}

TEST_F(WindowSize, IsTheUsualOneWhereTheFileIsSomethingElse) {
    fs::create_directory(folder_.path() / "drape");
    const fs::path file = window_size_file();
    for (const std::string& text : {std::string(), std::string("900"), std::string("-900x500"), std::string("9e2x500"),
                                    std::string("900x500\n1x1"), std::string("900x99999999"), std::string(99, '1')}) {
        std::ofstream(file) << text;
        EXPECT_EQ(kept(), "none") << text;
    }
    fs::remove(file);
    fs::create_directory(file);
    EXPECT_EQ(kept(), "none");
    keep_window_size({900, 500});
    fs::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(kept(), "none") << "and does not wait for a writer";
}

}  // namespace
}  // namespace drape
