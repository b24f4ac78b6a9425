#include "window_video.h"

#include <algorithm>

#include "drape/base/input_error.h"

namespace drape {

namespace {

constexpr double frame_rate = 30;  // pictures per second
constexpr int max_repeats = 15;    // of one picture: a window that was hidden for long leaves the rest out

std::filesystem::path first_free_name() {
    int number = 1;
    while (exists(symlink_status(numbered_name(number, ".mp4")))) ++number;
    return numbered_name(number, ".mp4");
}

}  // namespace

std::filesystem::path numbered_name(int number, const std::string& extension) {
    const std::string digits = std::to_string(number);
    return "drape-" + std::string(4 - std::min<std::size_t>(digits.size(), 4), '0') + digits + extension;
}

std::string WindowVideo::toggle(PictureSize size) {
    if (recording()) {
        end("");
        return "Video: " + pipe_->file().string() + " is being finished";
    }
    if (pipe_) return "The video before is still being finished";
    try {
        pipe_.emplace(first_free_name(), size, frame_rate, signals_, VideoPipe::Use::Live, end_patience_);
    } catch (const RunError& error) {
        return std::string("No video: ") + error.what();
    }
    size_ = size;
    frames_ = left_out_ = 0;
    ending_ = false;
    reason_.clear();
    watch_ = Stopwatch();
    if (!pipe_->error().empty()) return outcome();
    return "Recording video to " + pipe_->file().string() + ", Shift+F12 ends it";
}

int WindowVideo::due_frames() const {
    return recording() ? static_cast<int>(watch_.seconds() * frame_rate) + 1 - frames_ - left_out_ : 0;
}

void WindowVideo::take(const Image& picture) {
    const int due = due_frames(), repeats = std::min(due, max_repeats);
    left_out_ += due - repeats;
    for (int i = 0; i < repeats && pipe_->error().empty(); ++i) {
        pipe_->write(picture);
        ++frames_;
    }
    if (!pipe_->error().empty()) end("");
}

void WindowVideo::resize(PictureSize size) {
    if (recording() && (size.width != size_.width || size.height != size_.height)) end("; the window has another size");
}

void WindowVideo::end(const std::string& reason) {
    ending_ = true;
    reason_ = reason;
    pipe_->end();
}

std::string WindowVideo::news() { return ending_ && pipe_->finished(0) ? outcome() : ""; }

std::string WindowVideo::close() {
    if (!pipe_) return {};
    ending_ = true;
    pipe_->close();
    return outcome();
}

std::string WindowVideo::outcome() {
    const std::string file = pipe_->file().string(), error = pipe_->error();
    pipe_.reset();
    ending_ = false;
    if (!error.empty()) return "No video: " + error;
    if (frames_ == 0) return "No video: it has ended before its first picture";
    return "Video written: " + file + ", " + std::to_string(frames_) + (frames_ == 1 ? " frame" : " frames") + reason_;
}

}  // namespace drape
