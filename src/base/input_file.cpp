#include "drape/base/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "drape/base/input_error.h"

namespace drape {
namespace {

/// What a file is that is no regular one; empty if it is regular.
std::string odd_kind(mode_t mode) {
    if (S_ISREG(mode)) return {};
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

/// Whether a name means what somebody has opened for us: that cannot wait for an opener.
bool is_open_already(const std::string& name) { return name == "/dev/stdin" || name.starts_with("/dev/fd/"); }

}  // namespace

std::string read_text(const std::string& name, std::uintmax_t largest, InputKind kind) {
    const auto fail = [&name](const std::string& why) { throw InputError(name + ": " + why); };
    // Without O_NONBLOCK a pipe would wait for its writer before it could be told from a file
    const int file = ::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const std::shared_ptr<void> closed_at_the_end(nullptr, [file](void*) { ::close(file); });
    struct stat status {};
    if (file < 0 || ::fstat(file, &status) != 0) fail(std::string("cannot be read: ") + std::strerror(errno));
    const std::string odd = odd_kind(status.st_mode);
    const bool open_already = kind == InputKind::RegularOrOpen && is_open_already(name) && !S_ISDIR(status.st_mode);
    if (!odd.empty() && !open_already) fail("is " + odd + ": allowed a regular file");
    if (odd.empty() && static_cast<std::uintmax_t>(status.st_size) > largest) {
        fail(std::to_string(status.st_size) + " bytes: allowed at most " + std::to_string(largest));
    }
    ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
    std::string text;
    for (std::array<char, 1 << 16> bytes;;) {
        const ssize_t count = ::read(file, bytes.data(), bytes.size());
        if (count == 0) return text;
        if (count < 0 && errno != EINTR) fail(std::string("cannot be read: ") + std::strerror(errno));
        if (count < 0) continue;
        text.append(bytes.data(), static_cast<std::size_t>(count));
        if (text.size() > largest) fail("has more bytes than are allowed");
    }
}

LineEnd read_line(std::istream& in, std::string& line, std::size_t longest) {
    line.clear();
    const auto ended = [&line](LineEnd end) {
        while (line.ends_with('\r')) line.pop_back();
        return end;
    };
    for (char c = 0; in.get(c);) {
        if (c == '\n') return ended(LineEnd::Whole);
        if (line.size() == longest) return LineEnd::TooLong;
        line += c;
    }
    return line.empty() ? LineEnd::None : ended(LineEnd::CutOff);
}

}  // namespace drape
