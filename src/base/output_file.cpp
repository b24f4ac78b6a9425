#include "drape/base/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "drape/base/input_error.h"

namespace drape {
namespace {

bool same_file(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/// A descriptor of a file that is not to be replaced by another one; nothing for a file that is.
std::optional<int> open_directly(const std::string& name) {
    struct stat named {};
    if (stat(name.c_str(), &named) != 0 || S_ISDIR(named.st_mode)) return std::nullopt;
    // Standard output may lead to a file: opened once more, each would overwrite what the other writes
    for (const int own : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat opened {};
        if (fstat(own, &opened) == 0 && same_file(named, opened)) return fcntl(own, F_DUPFD_CLOEXEC, 0);
    }
    if (S_ISREG(named.st_mode)) return std::nullopt;
    // Without waiting for a reader of a FIFO that may never come
    const int descriptor = open(name.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor >= 0) fcntl(descriptor, F_SETFL, 0);
    return descriptor;
}

bool is_device(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored);
}

bool are_one(const std::filesystem::path& one, const std::filesystem::path& other) {
    if (is_device(one) || is_device(other)) return false;
    std::error_code missing;
    return std::filesystem::equivalent(one, other, missing) || link_target(one) == link_target(other);
}

}  // namespace

std::string OutputFile::Buffer::reason() const { return error_ == 0 ? "" : std::string(": ") + std::strerror(error_); }

OutputFile::Buffer::int_type OutputFile::Buffer::overflow(int_type c) {
    const int_type done = stdio_filebuf::overflow(c);
    if (traits_type::eq_int_type(done, traits_type::eof()) && error_ == 0) error_ = errno;
    return done;
}

std::streamsize OutputFile::Buffer::xsputn(const char* text, std::streamsize size) {
    const std::streamsize done = stdio_filebuf::xsputn(text, size);
    if (done != size && error_ == 0) error_ = errno;
    return done;
}

OutputFile::OutputFile(const std::string& name, LeftOver left_over) : name_(name) {
    if (name_.empty()) return;
    std::optional<int> descriptor = open_directly(name_);
    if (!descriptor) {
        unfinished_.emplace(name_, left_over);
        // A second one of the same opening: the lock stays when the stream is closed
        descriptor = fcntl(unfinished_->descriptor(), F_DUPFD_CLOEXEC, 0);
    }
    if (*descriptor < 0) throw RunError(name_ + ": cannot be written: " + std::strerror(errno));
    out_.rdbuf(&buffer_.emplace(*descriptor, std::ios::out | std::ios::binary));
}

std::filesystem::path OutputFile::set_aside() const {
    return unfinished_ ? unfinished_->set_aside() : std::filesystem::path();
}

void OutputFile::flush() {
    if (!wanted()) return;
    if (!out_.flush()) throw RunError(name_ + ": could not be written whole" + buffer_->reason());
}

bool OutputFile::cut_at(std::int64_t byte) {
    flush();
    if (!unfinished_ || ftruncate(buffer_->fd(), byte) != 0) return false;
    out_.seekp(byte);
    return static_cast<bool>(out_);
}

void OutputFile::end_stream() {
    flush();
    if (buffer_->close() == nullptr) throw RunError(name_ + ": could not be written whole: " + std::strerror(errno));
}

void OutputFile::close() {
    if (!wanted()) return;
    end_stream();
    if (unfinished_) unfinished_->finish();
}

bool OutputFile::close_if_free() {
    if (!wanted()) return true;
    end_stream();
    return !unfinished_ || unfinished_->finish_if_free();
}

void check_apart(const std::vector<NamedFile>& files) {
    for (auto file = files.begin(); file != files.end(); ++file) {
        for (auto other = files.begin(); other != file; ++other) {
            const bool written = file->use == NamedFile::Use::Write || other->use == NamedFile::Use::Write;
            if (!written || file->path.empty() || other->path.empty() || !are_one(file->path, other->path)) continue;
            const std::string first = file->path == other->path ? "" : " " + other->path.string();
            throw InputError(other->option + first + " and " + file->option + " " + file->path.string() +
                             (first.empty() ? "" : ", the same file") + ": allowed two different files");
        }
    }
}

}  // namespace drape
