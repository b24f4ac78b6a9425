#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace drape {

/// Width and height of a picture [pixel].
struct PictureSize {
    int width = 1280;
    int height = 720;
};

/// Reads "1280x720".
/// @throws InputError unless both lie in 1 to 8192
PictureSize parse_size(const std::string& text);

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

/// Writes a PNG as an `OutputFile`.
/// @throws RunError naming the file and the reason; no half-written file of that name is ever left
void write_png(const Image& image, const std::filesystem::path& name);

/// The same, unless a file has that name.
/// @return false if one has: it stays
/// @throws RunError
[[nodiscard]] bool write_new_png(const Image& image, const std::filesystem::path& name);

/// @throws InputError if it is no PNG
Image read_png(const std::filesystem::path& file);

}  // namespace drape
