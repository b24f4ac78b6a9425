#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace drape {

class Simulation;

/// Width and height of a picture [pixel].
struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// Reads "1280x720".
/// @throws InputError unless both lie in 1 to 8192
PictureSize parse_size(const std::string& text);

/// "1280x720"
std::string size_text(const PictureSize& size);

/// A text that goes with a picture, in UTF-8.
struct ImageText {
    std::string keyword;  ///< "Software": 1 to 79 printing characters of ASCII
    std::string text;
};

/// A picture: 8-bit RGB, rows from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    std::vector<ImageText> texts = {};  ///< written with it, and not read

    [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
        return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    }
};

/// What a picture of a simulation says of how to make it again: program, commit, scene, time and settings.
std::vector<ImageText> picture_texts(const Simulation& simulation);

/// Writes a PNG as an `OutputFile`.
/// @param only_new replaces no file
/// @return false if a file has that name that is not to be replaced
/// @throws RunError naming the file and the reason; no half-written file of that name is ever left
bool write_png(const Image& image, const std::filesystem::path& name, bool only_new = false);

}  // namespace drape
