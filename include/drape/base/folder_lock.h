#pragma once

#include <filesystem>

namespace drape {

/// Keeps other runs from writing the same files while it lives, and while its process does.
class FolderLock {
public:
    /// @param file the table, or what stands for all files that are written beside one another
    /// @throws RunError if another run holds it, or the folder cannot be written
    explicit FolderLock(const std::filesystem::path& file);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    std::filesystem::path name_;
    int descriptor_;
};

}  // namespace drape
