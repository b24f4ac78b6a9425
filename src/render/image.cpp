#include "drape/render/image.h"

#include <png.h>
#include <zlib.h>

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

}  // namespace

bool write_png(const Image& image, const std::filesystem::path& name, bool only_new) {
    OutputFile file(name.string());
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;  // a sixth of the time that better compression would take
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
    if (only_new) return file.close_if_free();
    file.close();
    return true;
}

PictureSize parse_size(const std::string& text) {
    const auto size = parse_integers(text, 'x');
    const auto fits = [](long long side) { return side >= 1 && side <= 8192; };
    if (!size || !fits(size->first) || !fits(size->second)) {
        throw InputError("--size " + shortened(text) + ": allowed WxH, 1 to 8192 each");
    }
    return {static_cast<int>(size->first), static_cast<int>(size->second)};
}

std::string size_text(const PictureSize& size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace drape
