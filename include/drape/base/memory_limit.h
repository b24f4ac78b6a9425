#pragma once

#include <string>
#include <string_view>

namespace drape {

/// The most memory that this program can have.
struct MemoryLimit {
    double bytes;
    std::string_view whose;  ///< for a message: "what this machine has"
};

/// The least of the machine's memory, the limit of the process's address space (`ulimit -v`), and that of its control
/// group, if it has one.
MemoryLimit memory_limit();

/// "3.1 GB", "640 MB": decimal units, two or three digits.
/// @param bytes at least 0
std::string bytes_text(double bytes);

}  // namespace drape
