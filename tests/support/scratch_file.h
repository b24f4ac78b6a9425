#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "support/scratch_folder.h"

namespace drape::test {

/// A file of this name in a folder of its own, gone with the object.
class ScratchFile {
public:
    explicit ScratchFile(const std::string& name) : path_(folder_.path() / name) {}
    ScratchFile(const std::string& name, std::string_view text) : ScratchFile(name) { write(text); }

    void write(std::string_view text) const { std::ofstream(path_, std::ios::binary) << text; }
    [[nodiscard]] std::string name() const { return path_.string(); }

private:
    ScratchFolder folder_;
    std::filesystem::path path_;
};

using drape::ScratchFolder;

}  // namespace drape::test
