#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "drape/base/unfinished_file.h"
#include "drape/render/image.h"

namespace drape {

/// Writes numbered pictures into a folder, each whole or not at all, with no other run writing there. A picture is
/// encoded in a thread of its own while the next one is drawn; they get their names in turn.
class FrameWriter {
public:
    /// Makes the folder if it is missing, and tries whether it takes files. What killed runs have left goes.
    /// @param frames the number of the last frame, for the width of the names
    /// @param again the frames of an earlier run may be replaced
    /// @throws InputError if there are any, and they may not
    /// @throws RunError if the folder takes no files, or another run writes there
    FrameWriter(std::filesystem::path folder, int frames, bool again);

    /// Starts to write a picture, once the one before is written.
    /// @throws RunError if the one before could not be written; it names the last good frame too
    void write(std::shared_ptr<const Image> image, int frame);

    /// Waits until the last picture is written.
    /// @throws RunError as `write` does
    void finish();

    /// The last picture that was written; empty if there is none.
    /// @pre `finish` was called since the last `write`
    [[nodiscard]] const std::filesystem::path& last() const { return last_; }

    /// How many frames of an earlier run are still there.
    [[nodiscard]] std::size_t older() const { return older_.size(); }

    /// Removes the frames of an earlier run that were not replaced.
    void remove_older();

    /// Whether a file has the name of a frame in that folder.
    static bool is_frame(const std::filesystem::path& folder, const std::filesystem::path& file);

private:
    std::filesystem::path folder_;
    std::size_t digits_;
    std::filesystem::path last_;
    std::optional<UnfinishedFile> lock_;
    std::set<std::string> older_;  ///< names of frames that this run has not written
    std::string name_;             ///< of the picture that is being written
    std::future<void> written_;    ///< of that; its end is waited for before the folder is let go
};

}  // namespace drape
