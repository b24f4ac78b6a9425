#include "include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <regex>
#include <string_view>

namespace drape::style {

namespace fs = std::filesystem;

namespace {

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

void check_file(const fs::path& file, const fs::path& root, std::vector<Offence>& offences) {
    static const std::regex include_line(R"re(\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
    const auto from = layer_of(file, root);
    if (!from) {
        offences.push_back({file.string(), 0, "in no layer"});
        return;
    }
    std::ifstream in(file);
    std::smatch match;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (!std::regex_match(line, match, include_line)) continue;
        const std::string wrong = judge(file, *from, match[1], root);
        if (!wrong.empty()) offences.push_back({file.string(), number, wrong});
    }
}

}  // namespace

std::vector<Offence> check_includes(const fs::path& root) {
    std::vector<Offence> offences;
    for (const fs::path& top : {root / "include" / "drape", root / "src"}) {
        if (!fs::exists(top)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(top)) {
            const std::string kind = entry.path().extension().string();
            if (kind == ".h" || kind == ".cpp") check_file(entry.path(), root, offences);
        }
    }
    return offences;
}

}  // namespace drape::style
