#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace drape {

/// A file that a command line names.
struct NamedFile {
    enum class Use { Read, Write };

    std::string option;          ///< that names it: "--state"
    std::filesystem::path path;  ///< empty: none
    Use use = Use::Write;
};

/// To be called before any of them is opened.
/// @throws InputError naming two of them that are one file, by whatever names and links, if one of these is written;
///         devices may be
void check_apart(const std::vector<NamedFile>& files);

}  // namespace drape
