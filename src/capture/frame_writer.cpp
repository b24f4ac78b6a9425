#include "frame_writer.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "drape/base/input_error.h"

namespace drape {

namespace {

constexpr std::size_t least_digits = 4;

// A picture of noise of this side does not compress: as many bytes as a plain frame takes
constexpr int probe_side = 256;

void probe(const std::filesystem::path& folder) {
    Image noise{probe_side, probe_side, std::vector<std::uint8_t>(3 * probe_side * probe_side)};
    std::uint32_t seed = 1;
    for (std::uint8_t& byte : noise.rgb) {
        seed = seed * 1664525u + 1013904223u;
        byte = static_cast<std::uint8_t>(seed >> 24);
    }
    const std::filesystem::path file = folder / ".drape-probe.png";
    write_png(noise, file);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
}

}  // namespace

FrameWriter::FrameWriter(std::filesystem::path folder, int frames)
    : folder_(std::move(folder)), digits_(std::max(least_digits, std::to_string(frames).size())) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (!std::filesystem::is_directory(folder_)) {
        throw RunError("--out " + folder_.string() + ": " + (error ? error.message() : "is no folder"));
    }
    try {
        probe(folder_);
    } catch (const RunError& failure) {
        throw RunError("--out " + folder_.string() + " takes no files: " + failure.what());
    }
}

void FrameWriter::write(const Image& image, int frame) {
    const std::string number = std::to_string(frame);
    const std::string zeros(digits_ - std::min(digits_, number.size()), '0');
    const std::filesystem::path file = folder_ / ("frame_" + zeros + number + ".png");
    try {
        write_png(image, file);
    } catch (const RunError& failure) {
        const std::string last = last_.empty() ? "no frame was written" : "the last good frame is " + last_.string();
        throw RunError(std::string(failure.what()) + "; " + last);
    }
    last_ = file;
}

}  // namespace drape
