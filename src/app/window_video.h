#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "drape/base/input_error.h"
#include "drape/base/stop_signals.h"
#include "drape/base/stopwatch.h"
#include "drape/render/video_pipe.h"

namespace drape {

/// "drape-0007.png": how the window calls what it writes, by the first number of which there is no file.
inline std::filesystem::path first_free_name(const std::string& extension) {
    for (int number = 1;; ++number) {
        const std::string digits = std::to_string(number), zeros(4 - std::min<std::size_t>(digits.size(), 4), '0');
        const std::filesystem::path file = "drape-" + zeros + digits + extension;
        if (!exists(symlink_status(file))) return file;
    }
}

/// A video of what a window shows, as fast as it is shown: 30 pictures a second of wall time, of which a slow window
/// repeats some. It is called "drape-0001.mp4", or by the next number of which there is no video.
/// @par Cost while it records, a picture is read back and given to ffmpeg up to 30 times a second; else none
class WindowVideo {
public:
    /// @param end_patience how long ffmpeg may take to finish its file when the program ends [s]
    explicit WindowVideo(const StopSignals& signals, double end_patience = VideoPipe::usual_end_patience)
        : signals_(signals), end_patience_(end_patience) {}

    /// Begins a video, or ends the one that is being recorded.
    /// @return what to tell the user
    std::string toggle(PictureSize size) {
        if (recording()) {
            end("");
            return "Video: " + pipe_->file().string() + " is being finished";
        }
        if (pipe_) return "The video before is still being finished";
        try {
            pipe_.emplace(first_free_name(".mp4"), size, frame_rate, signals_, VideoPipe::Use::Live, end_patience_);
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

    [[nodiscard]] bool recording() const { return pipe_ && !ending_; }

    /// Whether the time for another picture has come.
    [[nodiscard]] bool due() const { return due_frames() > 0; }

    /// Takes a picture, which has the video's size.
    void take(const Image& picture) {
        const int due = due_frames(), repeats = std::min(due, max_repeats);
        left_out_ += due - repeats;
        for (int i = 0; i < repeats && pipe_->error().empty(); ++i) {
            pipe_->write(picture);
            ++frames_;
        }
        if (!pipe_->error().empty()) end("");
    }

    /// The window has this size now: a video of another ends.
    void resize(PictureSize size) {
        if (recording() && (size.width != size_.width || size.height != size_.height))
            end("; the window has another size");
    }

    /// What has become of a video that has ended since the last call; empty if there is nothing to tell.
    std::string news() { return ending_ && pipe_->finished(0) ? outcome() : ""; }

    /// Ends the video, and waits until it is written.
    /// @return what has become of it; empty if there was none
    std::string close() {
        if (!pipe_) return {};
        ending_ = true;
        pipe_->close();
        return outcome();
    }

private:
    static constexpr double frame_rate = 30;  ///< pictures per second
    static constexpr int max_repeats = 15;    ///< of one picture: a window that was hidden for long leaves the rest out

    [[nodiscard]] int due_frames() const {
        return recording() ? static_cast<int>(watch_.seconds() * frame_rate) + 1 - frames_ - left_out_ : 0;
    }

    void end(const std::string& reason) {
        ending_ = true;
        reason_ = reason;
        pipe_->end();
    }

    std::string outcome() {
        const std::string file = pipe_->file().string(), error = pipe_->error();
        pipe_.reset();
        ending_ = false;
        if (!error.empty()) return "No video: " + error;
        if (frames_ == 0) return "No video: it has ended before its first picture";
        return "Video written: " + file + ", " + std::to_string(frames_) + (frames_ == 1 ? " frame" : " frames") +
               reason_;
    }

    const StopSignals& signals_;
    double end_patience_;
    std::optional<VideoPipe> pipe_;
    PictureSize size_;
    Stopwatch watch_;  ///< since the first picture
    int frames_ = 0, left_out_ = 0;
    bool ending_ = false;  ///< ffmpeg finishes its file
    std::string reason_;   ///< of an end that the user has not asked for
};

}  // namespace drape
