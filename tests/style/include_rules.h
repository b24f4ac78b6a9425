#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace drape::style {

/// An include line that the house does not allow.
struct Offence {
    std::string file;
    int line;
    std::string text;  ///< what is wrong with it
};

/// Checks every source under `root/include/drape` and `root/src`: a layer includes only itself and layers below it, the
/// programs never include one another, and only render, app and capture name OpenGL.
std::vector<Offence> check_includes(const std::filesystem::path& root);

}  // namespace drape::style
