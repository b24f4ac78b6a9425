#pragma once

#include <filesystem>
#include <optional>
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

/// The limit of the process's address space (`ulimit -v`) [bytes]; nothing if there is none.
std::optional<double> address_space_limit();

/// The least limit of memory of a process's control group and those above it [bytes], of version 1 or 2; nothing if
/// none has one.
/// @param groups names the process's groups
/// @param mounted where the groups' folders are
std::optional<double> control_group_limit(const std::filesystem::path& groups = "/proc/self/cgroup",
                                          const std::filesystem::path& mounted = "/sys/fs/cgroup");

/// "3.1 GB", "640 MB": decimal units, two or three digits.
/// @param bytes at least 0
std::string bytes_text(double bytes);

}  // namespace drape
