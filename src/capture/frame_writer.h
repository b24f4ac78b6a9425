#pragma once

#include <filesystem>
#include <string>

#include "drape/render/image.h"

namespace drape {

/// Writes numbered pictures into a folder, each whole or not at all.
class FrameWriter {
public:
    /// Makes the folder if it is missing, and tries whether it takes files.
    /// @param frames the number of the last frame, for the width of the names
    /// @throws RunError if it does not
    FrameWriter(std::filesystem::path folder, int frames);

    /// @throws RunError that names the last good frame too
    void write(const Image& image, int frame);

    /// The last picture that was written; empty if there is none.
    [[nodiscard]] const std::filesystem::path& last() const { return last_; }

private:
    std::filesystem::path folder_;
    std::size_t digits_;
    std::filesystem::path last_;
};

}  // namespace drape
