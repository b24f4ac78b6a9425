#pragma once

#include <string>

namespace drape {

/// Width and height of a picture [pixel].
struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// Reads "1280x720".
/// @throws InputError unless both lie in 1 to 8192
PictureSize parse_size(const std::string& text);

}  // namespace drape
