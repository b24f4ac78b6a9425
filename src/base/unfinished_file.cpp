#include "drape/base/unfinished_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "drape/base/input_error.h"

namespace drape {
namespace {

namespace files = std::filesystem;

constexpr std::string_view mark = ".drape";

// A name of more than 255 bytes is none.
constexpr std::size_t longest_stem = 160, longest_extension = 32;

[[noreturn]] void fail(const files::path& file, const std::string& reason) {
    throw RunError(file.string() + ": cannot be written: " + reason);
}

/// ".state.drape.csv"
files::path hidden_name(const files::path& file) {
    std::string stem = file.stem().string(), extension = file.extension().string();
    if (extension.size() > longest_extension) {
        stem += extension;
        extension.clear();
    }
    return file.parent_path() / ("." + stem.substr(0, longest_stem) + std::string(mark) + extension);
}

/// Whether a file that is open still has this name.
bool has_name(int descriptor, const files::path& name) {
    struct stat open_file {
    }, named{};
    return fstat(descriptor, &open_file) == 0 && lstat(name.c_str(), &named) == 0 && open_file.st_ino == named.st_ino &&
           open_file.st_dev == named.st_dev;
}

/// @return 0, or what stands in the way: EEXIST if a file has that name
int rename_if_free(const files::path& from, const files::path& to) {
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    // A file system that has no such way to rename
    if (link(from.c_str(), to.c_str()) != 0) return errno;
    return unlink(from.c_str()) == 0 ? 0 : errno;
}

/// The bytes reach the disk before the name does: after a crash of the system it is no name of an empty file.
void keep_bytes(int descriptor, const files::path& file) {
    // Some file systems have no such thing
    if (fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) fail(file, std::strerror(errno));
}

/// Gives a file the first free name of those that lie beside another.
files::path rename_beside(const files::path& from, const files::path& other) {
    for (int number = 1;; ++number) {
        files::path name =
            other.parent_path() / (other.stem().string() + "-" + std::to_string(number) + other.extension().string());
        const int error = rename_if_free(from, name);
        if (error == 0) return name;
        if (error != EEXIST) fail(name, std::strerror(error));
    }
}

}  // namespace

files::path link_target(const files::path& name) {
    constexpr int most_links = 40;
    std::error_code ignored;
    files::path file = files::absolute(name);
    for (int links = 0; links < most_links && files::is_symlink(files::symlink_status(file, ignored)); ++links) {
        file = file.parent_path() / files::read_symlink(file, ignored);
    }
    const files::path folder = files::weakly_canonical(file.parent_path(), ignored);
    return ignored ? file : folder / file.filename();
}

void remove_left_over(const files::path& file) {
    const std::string name = file.filename().string();
    if (!name.starts_with('.') || name.find(mark) == std::string::npos) return;
    const int found = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (found < 0) return;
    struct stat there {};
    const bool is_file = fstat(found, &there) == 0 && S_ISREG(there.st_mode);
    if (is_file && flock(found, LOCK_EX | LOCK_NB) == 0 && has_name(found, file)) unlink(file.c_str());
    close(found);
}

files::path set_file_aside(const files::path& file) { return rename_beside(file, file); }

UnfinishedFile::UnfinishedFile(const files::path& file, LeftOver left_over)
    : file_(file), target_(link_target(file)), left_over_(left_over) {
    struct stat there {};
    if (stat(target_.c_str(), &there) == 0) {
        if (!S_ISREG(there.st_mode)) fail(file_, S_ISDIR(there.st_mode) ? "it is a folder" : "it is no regular file");
        if (faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(file_, std::strerror(errno));
    }
    name_ = left_over == LeftOver::Remove ? hidden_name(target_) : files::path(target_.string() + ".unfinished");
    open_locked();
    if (there.st_nlink == 0) return;
    // Nobody may read meanwhile who may not read it in the end. Not everybody may give it another owner, and not every
    // file system has modes
    const bool same_owner = fchown(descriptor_, there.st_uid, there.st_gid) == 0;
    const bool same_mode = fchmod(descriptor_, there.st_mode & (same_owner ? 07777 : 0777)) == 0;
    static_cast<void>(same_mode);
}

/// What a killed run has left is not written again: a program that it had started may still be writing it.
void UnfinishedFile::open_locked() {
    while (descriptor_ < 0) {
        descriptor_ = open(name_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0) fail(file_, name_.string() + ": " + std::strerror(errno));
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            close(descriptor_);
            fail(file_, "another run is writing " + name_.string());
        }
        // Without its name it is that of a run that has just ended
        struct stat found {};
        const bool usable = has_name(descriptor_, name_) && fstat(descriptor_, &found) == 0;
        if (usable && found.st_size == 0) return;
        if (usable && left_over_ == LeftOver::Keep) set_aside_ = set_file_aside(name_);
        if (usable && left_over_ == LeftOver::Remove && unlink(name_.c_str()) != 0) fail(name_, std::strerror(errno));
        close(descriptor_);
        descriptor_ = -1;
    }
}

UnfinishedFile::~UnfinishedFile() {
    // While it is locked nobody else has given its name to another file
    if (!finished_ && left_over_ == LeftOver::Remove) unlink(name_.c_str());
    close(descriptor_);
}

void UnfinishedFile::finish() {
    keep_bytes(descriptor_, file_);
    if (rename(name_.c_str(), target_.c_str()) != 0) fail(file_, std::strerror(errno));
    finished_ = true;
}

bool UnfinishedFile::finish_if_free() {
    keep_bytes(descriptor_, file_);
    const int error = rename_if_free(name_, target_);
    if (error == EEXIST) return false;
    if (error != 0) fail(file_, std::strerror(error));
    finished_ = true;
    return true;
}

files::path UnfinishedFile::finish_beside() {
    if (finish_if_free()) return file_;
    const files::path name = rename_beside(name_, target_);
    finished_ = true;
    return file_.parent_path() / name.filename();
}

}  // namespace drape
