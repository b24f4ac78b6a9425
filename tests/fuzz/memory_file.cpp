#include "fuzz/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include "fuzz/target.h"

namespace drape::fuzz {

MemoryFile::MemoryFile(std::string_view text)
    : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)), name_("/proc/self/fd/" + std::to_string(descriptor_)) {
    while (!text.empty()) {
        const ssize_t written = write(descriptor_, text.data(), text.size());
        require(written > 0, "a file in memory takes its text");
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

MemoryFile::~MemoryFile() { close(descriptor_); }

}  // namespace drape::fuzz
