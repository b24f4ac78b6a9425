#pragma once

#include <string>
#include <string_view>

namespace drape::fuzz {

/// A file that is in memory only, with a name that readers of files can open.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view text);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }

private:
    int descriptor_;
    std::string name_;
};

}  // namespace drape::fuzz
