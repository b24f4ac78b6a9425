#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drape {

/// What the command line of `drape` asks for.
struct Options {
    std::string scene;                     ///< name or path; empty if none was given
    std::vector<std::string> assignments;  ///< "name=value"
    std::string record;                    ///< file to write; empty: none
    std::string replay;                    ///< file to read; empty: none
    int width = 1280;
    int height = 720;
    bool hash = false;  ///< print the hash of the last state
};

/// @return nothing if the command line asked for text (`--help`, `--version`), which was printed
/// @throws InputError
std::optional<Options> read_options(int argc, char** argv);

}  // namespace drape
