#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "drape/base/child_program.h"
#include "drape/base/stop_signals.h"
#include "drape/base/unfinished_file.h"
#include "drape/render/image.h"

namespace drape {

/// Feeds frames to ffmpeg, which may be missing, die or stand still: that is a trouble to tell, not a reason to stop.
/// The file that was there before stays until ffmpeg has finished a new one.
class VideoPipe {
public:
    /// Starts ffmpeg. Pipes that break are no longer fatal to this process from here on.
    /// @param rate frames per second
    /// @param signals after the first of them, ffmpeg has a few seconds to take what there is
    /// @throws RunError if the file cannot be written
    VideoPipe(const std::filesystem::path& file, PictureSize size, double rate, const StopSignals& signals);
    ~VideoPipe();
    VideoPipe(const VideoPipe&) = delete;
    VideoPipe& operator=(const VideoPipe&) = delete;

    void write(const Image& image);

    /// Lets ffmpeg finish its file, and waits for it.
    void close();

    /// What went wrong, ffmpeg's status included; empty while all is well.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

private:
    void wait_for_room(double& waited);
    void give_up();

    const StopSignals& signals_;
    UnfinishedFile file_;
    std::optional<ChildProgram> ffmpeg_;  ///< nothing when it has ended
    bool fed_ = false;                    ///< with a whole picture
    std::string trouble_;
};

}  // namespace drape
