#include "drape/base/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "drape/base/numbers.h"

namespace drape {

namespace files = std::filesystem;

MemoryLimit memory_limit() {
    MemoryLimit least{static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)),
                      "what this machine has"};
    const auto lower = [&least](double bytes, std::string_view whose) {
        if (bytes < least.bytes) least = {bytes, whose};
    };
    if (const auto space = address_space_limit()) lower(*space, "what this process may take (ulimit -v)");
    if (const auto group = control_group_limit()) lower(*group, "what this process's control group may take");
    return least;
}

std::optional<double> address_space_limit() {
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return std::nullopt;
    return static_cast<double>(space.rlim_cur);
}

std::optional<double> control_group_limit(const files::path& groups, const files::path& mounted) {
    std::optional<double> least;
    std::ifstream in(groups);
    for (std::string line, word; std::getline(in, line);) {
        // "0::/path" of version 2, "4:cpu,memory:/path" of version 1
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const bool is_second_version = controllers == ",,";
        if (!is_second_version && controllers.find(",memory,") == std::string::npos) continue;
        const files::path root = is_second_version ? mounted : mounted / "memory";
        // A container may see its own group as the root: folders that are not there have no file
        for (files::path group = line.substr(second + 1);; group = group.parent_path()) {
            std::ifstream file(root / group.relative_path() /
                               (is_second_version ? "memory.max" : "memory.limit_in_bytes"));
            const auto bytes = file >> word ? parse_real(word) : std::nullopt;
            // Version 1 has a number near 2^63 for no limit
            if (bytes && *bytes < 0x1p62 && !(least && *least <= *bytes)) least = bytes;
            if (!group.has_relative_path()) break;
        }
    }
    return least;
}

std::string bytes_text(double bytes) {
    constexpr double mega = 1e6, giga = 1e9;
    return bytes < giga ? real_text(bytes / mega, 3) + " MB" : real_text(bytes / giga, 3) + " GB";
}

}  // namespace drape
