#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "support/process.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

/// Calls of OpenGL that do not go through the counter: a function's name with arguments right behind it.
std::vector<std::string> uncounted_calls(const std::string& code) {
    static const std::regex call(R"(\b(gl[A-Z]\w*|__?glew\w*)\s*\()");
    std::vector<std::string> found;
    for (std::sregex_iterator match(code.begin(), code.end(), call), end; match != end; ++match) {
        found.push_back((*match)[1]);
    }
    return found;
}

TEST(GlCounting, NothingInTheRendererBypassesTheCounter) {
    EXPECT_EQ(uncounted_calls("gl(glClear, GL_COLOR_BUFFER_BIT); ::glFinish ();"),
              std::vector<std::string>{"glFinish"});
    int files = 0, counted = 0;
    const fs::path source = DRAPE_SOURCE_DIR;
    for (const fs::path& folder : {source / "src/render", source / "include/drape/render"}) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const std::string code = test::read_file(entry.path());
            EXPECT_EQ(uncounted_calls(code), std::vector<std::string>()) << entry.path();
            ++files;
            for (std::size_t at = code.find("(gl"); at != std::string::npos; at = code.find("(gl", at + 1)) ++counted;
        }
    }
    EXPECT_GT(files, 20);
    EXPECT_GT(counted, 50);
}

}  // namespace
}  // namespace drape
