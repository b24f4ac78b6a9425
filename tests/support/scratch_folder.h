#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "drape/base/input_error.h"

namespace drape {

/// An empty folder for temporary files that nobody else has, gone with the object with all that is in it by then.
class ScratchFolder {
public:
    /// @throws RunError if it cannot be made
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "drape-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw RunError(name + ": cannot be made");
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace drape
