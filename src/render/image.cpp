#include "drape/render/image.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <string_view>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"

namespace drape {

namespace {

std::string big_endian(std::uint32_t number) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xFF);
    return bytes;
}

/// A chunk "iTXt" of a PNG: not compressed, of no language.
std::string text_chunk(const ImageText& text) {
    using namespace std::string_view_literals;
    const std::string body = "iTXt" + text.keyword + std::string("\0\0\0\0\0"sv) + text.text;
    const auto* bytes = reinterpret_cast<const Bytef*>(body.data());
    const auto sum = static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(body.size())));
    return big_endian(static_cast<std::uint32_t>(body.size() - 4)) + body + big_endian(sum);
}

/// Encodes a picture into a file that is still to get its name. The fast way of libpng takes a sixth of the time that
/// better compression would.
void write_to(OutputFile& file, const Image& image, const std::filesystem::path& name) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<char> bytes(size);
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr)) {
        throw RunError(name.string() + " cannot be written: " + png.message);
    }
    // Texts stand between the header, which has one length in all PNGs, and the picture
    constexpr std::size_t header = 33;
    file.stream().write(bytes.data(), header);
    for (const ImageText& text : image.texts) file.stream() << text_chunk(text);
    file.stream().write(bytes.data() + header, static_cast<std::streamsize>(size - header));
}

}  // namespace

PictureSize parse_size(const std::string& text) {
    const std::size_t by = std::min(text.find('x'), text.size());
    const auto side = [&](const std::string& part) {
        const auto number = parse_integer(part);
        if (!number || *number < 1 || *number > 8192) {
            throw InputError("--size " + shortened(text) + ": allowed WxH, 1 to 8192 each");
        }
        return static_cast<int>(*number);
    };
    return {side(text.substr(0, by)), side(by < text.size() ? text.substr(by + 1) : "")};
}

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
