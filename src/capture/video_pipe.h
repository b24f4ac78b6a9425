#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "drape/render/image.h"

namespace drape {

/// Feeds frames to ffmpeg, which may be missing or die: that is a trouble to tell, not a reason to stop.
class VideoPipe {
public:
    /// Starts ffmpeg. Pipes that break are no longer fatal to this process from here on.
    /// @param rate frames per second
    VideoPipe(const std::filesystem::path& file, int width, int height, double rate);
    ~VideoPipe();
    VideoPipe(const VideoPipe&) = delete;
    VideoPipe& operator=(const VideoPipe&) = delete;

    void write(const Image& image);

    /// Lets ffmpeg finish its file, and waits for it.
    void close();

    /// What went wrong, ffmpeg's status included; empty while all is well.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

private:
    void stop_feeding();

    int input_ = -1;
    pid_t process_ = -1;
    std::string trouble_;
};

}  // namespace drape
