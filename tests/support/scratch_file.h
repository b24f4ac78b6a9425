#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "support/scratch_folder.h"

namespace drape::test {

/// A file of this process's own, gone with the object.
class ScratchFile {
public:
    explicit ScratchFile(const std::string& name)
        : path_(std::filesystem::path(testing::TempDir()) / ("drape_" + std::to_string(getpid()) + "_" + name)) {}
    ScratchFile(const std::string& name, std::string_view text) : ScratchFile(name) { write(text); }
    ~ScratchFile() { std::filesystem::remove(path_); }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    void write(std::string_view text) const { std::ofstream(path_, std::ios::binary) << text; }
    [[nodiscard]] std::string name() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

using drape::ScratchFolder;

}  // namespace drape::test
