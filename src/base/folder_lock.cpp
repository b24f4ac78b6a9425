#include "drape/base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "drape/base/input_error.h"
#include "drape/base/unfinished_file.h"

namespace drape {

FolderLock::FolderLock(const std::filesystem::path& file)
    : name_(file.string() + ".lock"), descriptor_(open(name_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) throw RunError(name_.string() + ": cannot be written");
    // Without its name it is that of a run that has just ended
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && has_name(descriptor_, name_)) return;
    close(descriptor_);
    throw RunError(file.string() + ": another run is writing it; name another folder by --out");
}

FolderLock::~FolderLock() {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
    close(descriptor_);
}

}  // namespace drape
