#include "drape/render/image.h"

#include <fcntl.h>
#include <stb_image.h>
#include <stb_image_write.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

#include "drape/base/input_error.h"

namespace drape {

namespace {

// A file that is being written under a name of its own; gone if it is not finished.
class UnfinishedFile {
public:
    explicit UnfinishedFile(const std::filesystem::path& file)
        : file_(file), name_(file.string() + ".part" + std::to_string(::getpid())) {
        descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail("cannot be created");
    }

    ~UnfinishedFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!finished_) ::unlink(name_.c_str());
    }

    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    void write(const unsigned char* data, std::size_t size) {
        while (size > 0) {
            const ssize_t written = ::write(descriptor_, data, size);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail("cannot be written");
            data += written;
            size -= static_cast<std::size_t>(written);
        }
    }

    void finish() {
        if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("cannot be written");
        const int descriptor = descriptor_;
        descriptor_ = -1;
        if (::close(descriptor) != 0) fail("cannot be written");
        if (::rename(name_.c_str(), file_.c_str()) != 0) fail("cannot be written");
        finished_ = true;
    }

private:
    [[noreturn]] void fail(const std::string& what) {
        const std::string reason = std::strerror(errno);
        if (descriptor_ >= 0) ::close(descriptor_);
        descriptor_ = -1;
        ::unlink(name_.c_str());
        throw RunError(file_.string() + " " + what + ": " + reason);
    }

    std::filesystem::path file_;
    std::string name_;
    int descriptor_ = -1;
    bool finished_ = false;
};

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
    std::vector<unsigned char> png;
    const auto append = [](void* all, void* data, int size) {
        auto& bytes = *static_cast<std::vector<unsigned char>*>(all);
        bytes.insert(bytes.end(), static_cast<unsigned char*>(data), static_cast<unsigned char*>(data) + size);
    };
    if (!stbi_write_png_to_func(append, &png, image.width, image.height, 3, image.rgb.data(), 3 * image.width)) {
        throw RunError(file.string() + " cannot be written: no PNG of this picture");
    }
    UnfinishedFile unfinished(file);
    unfinished.write(png.data(), png.size());
    unfinished.finish();
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
