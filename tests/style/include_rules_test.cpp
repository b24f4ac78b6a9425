#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <regex>
#include <string_view>

#include "support/scratch_file.h"

namespace drape::style {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 12> layers{"base", "model",   "integrate", "bounds", "contact", "scene",
                                                  "sim",  "session", "render",    "app",    "capture", "lab"};
constexpr std::size_t render = 8;  // the programs come after it
constexpr std::size_t lab = 11;

std::optional<std::size_t> rank_of(std::string_view layer) {
    const auto found = std::ranges::find(layers, layer);
    if (found == layers.end()) return std::nullopt;
    return static_cast<std::size_t>(found - layers.begin());
}

bool may_include(std::size_t from, std::size_t to) {
    if (from == to) return true;
    if (to > render) return false;
    if (from == lab) return to < render;
    return to < from;
}

// The layer of a file: the folder below include/drape or src.
std::optional<std::size_t> layer_of(const fs::path& file, const fs::path& root) {
    for (const fs::path& top : {root / "include" / "drape", root / "src"}) {
        const fs::path inside = file.lexically_normal().lexically_relative(top.lexically_normal());
        if (!inside.empty() && *inside.begin() != "..") return rank_of(inside.begin()->string());
    }
    return std::nullopt;
}

bool names_opengl(const std::string& target) {
    static const std::regex pattern(R"((GL|GLES\d*|EGL|X11)/.*|imgui.*\.h|(.*/)?gl(ad|ew|ut)?\.h)");
    return std::regex_match(target, pattern);
}

std::string judge(const fs::path& file, std::size_t from, const std::string& target, const fs::path& root) {
    if (from < render && names_opengl(target)) return "OpenGL below render: " + target;
    if (from == lab && names_opengl(target)) return "OpenGL in lab: " + target;
    const bool shared = target.starts_with("drape/");
    const fs::path meant = shared ? root / "include" / target : file.parent_path() / target;
    const auto to = layer_of(meant, root);
    if (shared && !to) return "no layer: " + target;
    if (to && !may_include(from, *to))
        return std::string(layers[from]) + " includes " + std::string(layers[*to]) + ": " + target;
    return {};
}

void check_file(const fs::path& file, const fs::path& root, std::vector<std::string>& offences) {
    static const std::regex include_line(R"re(\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
    const auto from = layer_of(file, root);
    if (!from) {
        offences.push_back(file.string() + ": in no layer");
        return;
    }
    std::ifstream in(file);
    std::smatch match;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (!std::regex_match(line, match, include_line)) continue;
        const std::string wrong = judge(file, *from, match[1], root);
        if (!wrong.empty()) offences.push_back(file.string() + ":" + std::to_string(number) + ": " + wrong);
    }
}

/// What is wrong with the include lines of every source under `root/include/drape` and `root/src`, each with its place:
/// a layer includes only itself and layers below it, the programs never include one another, and only render, app and
/// capture name OpenGL.
std::vector<std::string> check_includes(const fs::path& root) {
    std::vector<std::string> offences;
    for (const fs::path& top : {root / "include" / "drape", root / "src"}) {
        if (!fs::exists(top)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(top)) {
            const std::string kind = entry.path().extension().string();
            if (kind == ".h" || kind == ".cpp") check_file(entry.path(), root, offences);
        }
    }
    return offences;
}

// A small house in which a test plants one include line.
class IncludeRules : public testing::Test {
protected:
    // What is wrong with the one line of the one file; empty if nothing.
    std::string verdict(const std::string& file, const std::string& line) {
        fs::remove_all(root_);
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << "#pragma once\n" << line << "\n";
        const std::vector<std::string> offences = check_includes(root_);
        return offences.empty() ? "" : offences.front();
    }

    test::ScratchFolder scratch_;
    const fs::path root_ = scratch_.path() / "house";
};

TEST_F(IncludeRules, HoldInThisRepository) {
    for (const std::string& offence : check_includes(DRAPE_SOURCE_DIR)) ADD_FAILURE() << offence;
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
