#include "drape/render/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <memory>
#include <string>

#include "drape/base/input_error.h"
#include "drape/base/output_file.h"

namespace drape {

namespace {

/// Encodes a picture into a file that is still to get its name.
void write_to(OutputFile& file, const Image& image, const std::filesystem::path& name) {
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::ostream*>(out)->write(static_cast<const char*>(data), size);
    };
    if (!stbi_write_png_to_func(append, &file.stream(), image.width, image.height, 3, image.rgb.data(),
                                3 * image.width)) {
        throw RunError(name.string() + " cannot be written: no PNG of this picture");
    }
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& name) {
    OutputFile file(name.string());
    write_to(file, image, name);
    file.close();
}

bool write_new_png(const Image& image, const std::filesystem::path& name) {
    OutputFile file(name.string());
    write_to(file, image, name);
    return file.close_if_free();
}

Image read_png(const std::filesystem::path& file) {
    Image image;
    int channels = 0;
    const std::unique_ptr<unsigned char, decltype(&stbi_image_free)> pixels(
        stbi_load(file.c_str(), &image.width, &image.height, &channels, 3), &stbi_image_free);
    if (!pixels) throw InputError(file.string() + " is no picture that can be read: " + stbi_failure_reason());
    const std::size_t size = 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgb.assign(pixels.get(), pixels.get() + size);
    return image;
}

}  // namespace drape
