#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "drape/base/stop_signals.h"
#include "drape/base/stopwatch.h"
#include "drape/render/video_pipe.h"

namespace drape {

/// "drape-0007.png": how the window calls what it writes.
std::filesystem::path numbered_name(int number, const std::string& extension);

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
    std::string toggle(PictureSize size);

    [[nodiscard]] bool recording() const { return pipe_ && !ending_; }

    /// Whether the time for another picture has come.
    [[nodiscard]] bool due() const { return due_frames() > 0; }

    /// Takes a picture, which has the video's size.
    void take(const Image& picture);

    /// The window has this size now: a video of another ends.
    void resize(PictureSize size);

    /// What has become of a video that has ended since the last call; empty if there is nothing to tell.
    std::string news();

    /// Ends the video, and waits until it is written.
    /// @return what has become of it; empty if there was none
    std::string close();

private:
    [[nodiscard]] int due_frames() const;
    void end(const std::string& reason);
    std::string outcome();

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
