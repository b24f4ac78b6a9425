#pragma once

#include <filesystem>

namespace drape {

/// A file under a temporary name beside the one that it is to have, and locked while its owner lives. No file is
/// touched that was there before, until `finish`. One that is made as a lock, and never finished,
/// keeps other runs out of a folder.
class UnfinishedFile {
public:
    /// What the temporary name is, and what becomes of a file under it that a killed run has left.
    enum class LeftOver {
        Remove,  ///< a hidden name, ".state.drape.csv"; what is left is removed
        Keep,    ///< a name for people, "session.txt.unfinished"; what is left is set aside
    };

    /// Makes the temporary file. A link is followed: what it leads to is written.
    /// @throws RunError if it cannot be made, or the file may not be written, or another run is writing it
    explicit UnfinishedFile(const std::filesystem::path& file, LeftOver left_over = LeftOver::Remove);

    /// Removes what was not finished, unless it is to be kept.
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    /// The temporary name. It has the extension of the file.
    [[nodiscard]] const std::filesystem::path& name() const { return name_; }

    /// Open for writing until the end of this object.
    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// Where a killed run's file has gone; empty if there was none.
    [[nodiscard]] const std::filesystem::path& set_aside() const { return set_aside_; }

    /// Gives it its own name, in place of a file that was there, whose permissions it takes on.
    /// @throws RunError
    void finish();

    /// Gives it its own name if no file has that.
    /// @return false if one has
    /// @throws RunError
    [[nodiscard]] bool finish_if_free();

    /// Gives it its own name, or where a file has that, the first free one of "NAME-1.mp4", "NAME-2.mp4" ...
    /// @return its name
    /// @throws RunError
    std::filesystem::path finish_beside();

private:
    void open_locked();

    std::filesystem::path file_;    ///< as it was named, for messages
    std::filesystem::path target_;  ///< what is written in the end
    std::filesystem::path name_, set_aside_;
    LeftOver left_over_;
    int descriptor_ = -1;
    bool finished_ = false;
};

/// Where a file of this name is written: links are followed, also those that lead to nothing yet, and the folder is
/// named in one way.
std::filesystem::path link_target(const std::filesystem::path& name);

/// Removes a file with a hidden temporary name whose owner is dead; leaves any other alone.
void remove_left_over(const std::filesystem::path& file);

/// Gives a file the first free of the names "NAME-1.csv", "NAME-2.csv" ...
/// @return that name
/// @throws RunError
std::filesystem::path set_file_aside(const std::filesystem::path& file);

}  // namespace drape
