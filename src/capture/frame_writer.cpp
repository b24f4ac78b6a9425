#include "frame_writer.h"

#include <algorithm>
#include <random>
#include <system_error>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/output_file.h"

namespace drape {

namespace {

namespace files = std::filesystem;

constexpr std::size_t least_digits = 4;

constexpr std::string_view prefix = "frame_", extension = ".png";

bool is_frame_name(const std::string& name) {
    if (!name.starts_with(prefix) || !name.ends_with(extension)) return false;
    const std::size_t end = name.size() - extension.size();
    return end > prefix.size() && name.find_first_not_of("0123456789", prefix.size()) == end;
}

// As many bytes as a plain frame takes, which no file system makes fewer
void probe(const files::path& folder) {
    std::string noise(200'000, '\0');
    std::mt19937 random;
    for (char& byte : noise) byte = static_cast<char>(random());
    // It never gets its name, and goes with the object
    OutputFile file((folder / "frame_.png").string());
    file.stream() << noise;
    file.flush();
}

}  // namespace

FrameWriter::FrameWriter(files::path folder, int frames, bool again)
    : folder_(std::move(folder)), digits_(std::max(least_digits, std::to_string(frames).size())) {
    std::error_code error;
    files::create_directories(folder_, error);
    if (!files::is_directory(folder_)) {
        throw RunError("--out " + folder_.string() + ": " + (error ? error.message() : "is no folder"));
    }
    lock_.emplace(folder_ / "frames.lock");
    for (const auto& entry : files::directory_iterator(folder_)) {
        const std::string name = entry.path().filename().string();
        if (is_frame_name(name)) older_.insert(name);
        if (name.starts_with("." + std::string(prefix))) remove_left_over(entry.path());
    }
    if (!again && !older_.empty()) {
        throw InputError("--out " + folder_.string() + ": there is " + *older_.begin() +
                         " of an earlier run: name another folder, or --again to replace its frames");
    }
    try {
        probe(folder_);
    } catch (const RunError& failure) {
        throw RunError("--out " + folder_.string() + " takes no files: " + failure.what());
    }
}

bool FrameWriter::is_frame(const files::path& folder, const files::path& file) {
    const files::path target = link_target(file);
    return is_frame_name(target.filename().string()) && link_target(folder / "frame") == target.parent_path() / "frame";
}

void FrameWriter::write(std::shared_ptr<const Image> image, int frame) {
    finish();
    const std::string number = std::to_string(frame);
    const std::string zeros(digits_ - std::min(digits_, number.size()), '0');
    name_ = std::string(prefix) + zeros + number + std::string(extension);
    // Where no thread can be started, it is written when it is waited for
    written_ = std::async([image = std::move(image), file = folder_ / name_] { write_png(*image, file); });
}

void FrameWriter::finish() {
    if (!written_.valid()) return;
    try {
        written_.get();
    } catch (const RunError& failure) {
        const std::string last = last_.empty() ? "no frame was written" : "the last good frame is " + last_.string();
        throw RunError(std::string(failure.what()) + "; " + last);
    }
    older_.erase(name_);
    last_ = folder_ / name_;
}

void FrameWriter::remove_older() {
    for (const std::string& name : std::exchange(older_, {})) {
        std::error_code error;
        files::remove(folder_ / name, error);
        if (error) throw RunError((folder_ / name).string() + ": cannot be removed: " + error.message());
    }
}

}  // namespace drape
