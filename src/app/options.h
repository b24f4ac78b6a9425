#pragma once

#include <optional>
#include <string>

#include "drape/render/image.h"
#include "drape/session/start.h"

namespace drape {

/// What the command line of `drape` asks for.
struct Options {
    StartOptions start;
    std::string record;               ///< file to write; empty: none
    std::optional<PictureSize> size;  ///< of the window; nothing: as it was last, and that is kept
    bool tour = false;                ///< begin with the tour
    bool check = false;               ///< end at the first fault of OpenGL, or number that is not finite
};

/// @return nothing if the command line asked for text (`--help`, `--version`), which was printed
/// @throws InputError
std::optional<Options> read_options(int argc, char** argv);

}  // namespace drape
