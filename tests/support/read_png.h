#pragma once

#include <png.h>

#include "drape/base/input_error.h"
#include "drape/render/image.h"

namespace drape {

/// @throws InputError if it is no PNG
inline Image read_png(const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    Image image;
    if (png_image_begin_read_from_file(&png, file.c_str())) {
        png.format = PNG_FORMAT_RGB;
        image.width = static_cast<int>(png.width);
        image.height = static_cast<int>(png.height);
        image.rgb.resize(PNG_IMAGE_SIZE(png));
        if (png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) return image;
    }
    throw InputError(file.string() + " is no picture that can be read: " + png.message);
}

}  // namespace drape
