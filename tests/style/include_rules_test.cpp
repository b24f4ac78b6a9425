#include "include_rules.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/scratch_file.h"

namespace drape::style {
namespace {

namespace fs = std::filesystem;

// A small house in which a test plants one include line.
class IncludeRules : public testing::Test {
protected:
    // What is wrong with the one line of the one file; empty if nothing.
    std::string verdict(const std::string& file, const std::string& line) {
        fs::remove_all(root_);
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << "#pragma once\n" << line << "\n";
        const std::vector<Offence> offences = check_includes(root_);
        return offences.empty() ? "" : offences.front().text;
    }

    test::ScratchFolder scratch_;
    const fs::path root_ = scratch_.path() / "house";
};

TEST_F(IncludeRules, HoldInThisRepository) {
    for (const Offence& offence : check_includes(DRAPE_SOURCE_DIR)) {
        ADD_FAILURE() << offence.file << ":" << offence.line << ": " << offence.text;
    }
}

TEST_F(IncludeRules, LetALayerIncludeItselfAndLowerOnes) {
    EXPECT_EQ(verdict("include/drape/sim/a.h", "#include \"drape/model/grid.h\""), "");
    EXPECT_EQ(verdict("src/bounds/a.cpp", "#include \"own.h\""), "");
    EXPECT_EQ(verdict("src/app/a.cpp", "#include <GL/freeglut.h>"), "");
    EXPECT_EQ(verdict("src/capture/a.cpp", "#include \"drape/render/renderer.h\""), "");
    EXPECT_EQ(verdict("src/base/a.cpp", "#include <vector>"), "");
}

TEST_F(IncludeRules, FindAnUpwardInclude) {
    EXPECT_NE(verdict("include/drape/model/a.h", "#include \"drape/sim/settings.h\""), "");
    EXPECT_NE(verdict("src/base/a.cpp", "  #  include \"drape/model/grid.h\" // why"), "");
    EXPECT_NE(verdict("src/bounds/a.cpp", "#include <drape/contact/contact.h>"), "");
    EXPECT_NE(verdict("src/sim/a.cpp", "#include \"drape/render/camera.h\""), "");
}

TEST_F(IncludeRules, FindAnUpwardIncludeByARelativePath) {
    EXPECT_NE(verdict("src/model/a.cpp", "#include \"../sim/divergence.h\""), "");
}

TEST_F(IncludeRules, KeepTheProgramsApart) {
    EXPECT_NE(verdict("src/app/a.cpp", "#include \"../capture/context.h\""), "");
    EXPECT_NE(verdict("src/capture/a.cpp", "#include \"../lab/charts.h\""), "");
    EXPECT_NE(verdict("src/lab/a.cpp", "#include \"drape/render/image.h\""), "");
}

TEST_F(IncludeRules, KeepOpenGlInRenderAppAndCapture) {
    EXPECT_NE(verdict("src/lab/a.cpp", "#include <GL/glew.h>"), "");
    EXPECT_NE(verdict("src/sim/a.cpp", "#include <GL/gl.h>"), "");
    EXPECT_NE(verdict("include/drape/base/a.h", "#include \"imgui.h\""), "");
}

TEST_F(IncludeRules, FindAFileOutsideTheLayers) {
    EXPECT_NE(verdict("src/helpers/a.cpp", "#include <vector>"), "");
    EXPECT_NE(verdict("src/model/a.cpp", "#include \"drape/helpers/a.h\""), "");
}

}  // namespace
}  // namespace drape::style
