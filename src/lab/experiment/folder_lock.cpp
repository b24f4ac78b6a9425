#include "folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "drape/base/input_error.h"

namespace drape {

namespace {

/// False where the run before has just ended and taken the name away.
bool bears_name(int descriptor, const std::filesystem::path& name) {
    struct stat held {
    }, named{};
    return fstat(descriptor, &held) == 0 && stat(name.c_str(), &named) == 0 && held.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& file)
    : name_(file.string() + ".lock"), descriptor_(open(name_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) throw RunError(name_.string() + ": cannot be written");
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && bears_name(descriptor_, name_)) return;
    close(descriptor_);
    throw RunError(file.string() + ": another run is writing it; name another folder by --out");
}

FolderLock::~FolderLock() {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
    close(descriptor_);
}

}  // namespace drape
