#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "drape/base/child_program.h"
#include "drape/base/stop_signals.h"
#include "drape/base/unfinished_file.h"
#include "drape/render/image.h"

namespace drape {

/// Refuses a name by which ffmpeg would not make one file of video: others are a picture, many files or no format.
/// @param option for the message
/// @throws InputError
void check_video_name(const std::string& option, const std::filesystem::path& file);

/// Feeds frames to ffmpeg, which may be missing, die or stand still: that is an error to tell, not a reason to stop.
/// A file that was there before stays at least until ffmpeg has finished a new one.
class VideoPipe {
public:
    enum class Use {
        Batch,  ///< waits for an ffmpeg that stands still until a signal comes, and replaces the file of that name
        Live,   ///< waits 5 s for it, at the end longer, and leaves a file of that name alone: a number is added
    };
    static constexpr double usual_end_patience = 20;  ///< s

    /// Starts ffmpeg. Pipes that break are no longer fatal to this process from here on.
    /// @param rate frames per second
    /// @param signals after the first of them, ffmpeg has a few seconds to take what there is
    /// @param end_patience how long ffmpeg may take to finish its file where a user waits for the end [s]
    /// @throws RunError if the file cannot be written
    VideoPipe(const std::filesystem::path& file, PictureSize size, double rate, const StopSignals& signals,
              Use use = Use::Batch, double end_patience = usual_end_patience);
    ~VideoPipe();
    VideoPipe(const VideoPipe&) = delete;
    VideoPipe& operator=(const VideoPipe&) = delete;

    /// @pre the image has the video's size
    void write(const Image& image);

    /// There are no more frames: ffmpeg may finish its file.
    void end();

    /// Waits that long for ffmpeg to finish its file after `end`.
    /// @return whether it has, or has failed to
    bool finished(double seconds);

    /// Lets ffmpeg finish its file, and waits for it.
    void close();

    /// What went wrong, ffmpeg's status included; empty while all is well.
    [[nodiscard]] const std::string& error() const { return error_; }

    /// The name that the video has, or is to have.
    [[nodiscard]] const std::filesystem::path& file() const { return name_; }

private:
    void wait_for_room(double& waited);
    void give_up();
    void name_file();

    const StopSignals& signals_;
    Use use_;
    double end_patience_;
    std::filesystem::path name_;
    UnfinishedFile file_;
    std::optional<ChildProgram> ffmpeg_;  ///< nothing when it has ended
    bool fed_ = false;                    ///< with a whole picture
    std::string error_;
};

}  // namespace drape
