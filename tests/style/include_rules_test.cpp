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
    const std::pair<const char*, const char*> allowed[] = {
        {"include/drape/sim/a.h", "#include \"drape/model/grid.h\""},
        {"src/bounds/a.cpp", "#include \"own.h\""},
        {"src/app/a.cpp", "#include <GL/freeglut.h>"},
        {"src/capture/a.cpp", "#include \"drape/render/renderer.h\""},
        {"src/base/a.cpp", "#include <vector>"}};
    for (const auto& [file, line] : allowed) EXPECT_EQ(verdict(file, line), "") << file << ": " << line;
}

TEST_F(IncludeRules, FindUpwardIncludesOtherProgramsOpenGlBelowTheRendererAndFilesOutsideTheLayers) {
    const std::pair<const char*, const char*> forbidden[] = {
        {"include/drape/model/a.h", "#include \"drape/scene/settings.h\""},
        {"src/base/a.cpp", "  #  include \"drape/model/grid.h\" // why"},
        {"src/bounds/a.cpp", "#include <drape/contact/detection.h>"},
        {"src/sim/a.cpp", "#include \"drape/render/camera.h\""},
        {"src/model/a.cpp", "#include \"../sim/divergence.h\""},
        {"src/app/a.cpp", "#include \"../capture/context.h\""},
        {"src/capture/a.cpp", "#include \"../lab/charts.h\""},
        {"src/lab/a.cpp", "#include \"drape/render/image.h\""},
        {"src/lab/a.cpp", "#include <GL/glew.h>"},
        {"src/sim/a.cpp", "#include <GL/gl.h>"},
        {"include/drape/base/a.h", "#include \"imgui.h\""},
        {"src/helpers/a.cpp", "#include <vector>"},
        {"src/model/a.cpp", "#include \"drape/helpers/a.h\""}};
    for (const auto& [file, line] : forbidden) EXPECT_NE(verdict(file, line), "") << file << ": " << line;
}

}  // namespace
}  // namespace drape::style
