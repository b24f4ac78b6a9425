#pragma once

#include <filesystem>
#include <optional>

#include "drape/render/image.h"

namespace drape {

/// Where the size of the window is kept, as "1280x720": `drape/window` in the user's folder for what programs remember
/// ($XDG_STATE_HOME, or ~/.local/state). Empty: the user has none.
std::filesystem::path window_size_file();

/// The size that the window had last, within what a screen has room for, but at least 320x180.
/// @return nothing if there is none, or if the file has anything else in it
std::optional<PictureSize> kept_window_size(const PictureSize& screen);

/// Keeps a size for the next time. A user whose folder cannot be written has the usual size then.
void keep_window_size(const PictureSize& size);

}  // namespace drape
