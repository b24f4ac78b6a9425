#include "drape/base/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>

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

class Buffer : public std::streambuf {
public:
    Buffer(const std::string& name, std::uintmax_t largest, InputKind kind) : name_(name), left_(largest) {
        // Without O_NONBLOCK a pipe would wait for its writer before it could be told from a file
        file_ = ::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        struct stat status {};
        if (file_ < 0 || ::fstat(file_, &status) != 0) fail(std::string("cannot be read: ") + std::strerror(errno));
        const std::string odd = odd_kind(status.st_mode);
        const bool open_already = kind == InputKind::RegularOrOpen && is_open_already(name) && !S_ISDIR(status.st_mode);
        std::string why;
        if (!odd.empty() && !open_already) why = "is " + odd + ": allowed a regular file";
        if (odd.empty() && static_cast<std::uintmax_t>(status.st_size) > largest) {
            why = std::to_string(status.st_size) + " bytes: allowed at most " + std::to_string(largest);
        }
        if (!why.empty()) ::close(file_), fail(why);
        ::fcntl(file_, F_SETFL, ::fcntl(file_, F_GETFL) & ~O_NONBLOCK);
    }
    ~Buffer() override { ::close(file_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

protected:
    int_type underflow() override {
        ssize_t count = 0;
        do {
            count = ::read(file_, bytes_.data(), bytes_.size());
        } while (count < 0 && errno == EINTR);
        if (count < 0) fail(std::string("cannot be read: ") + std::strerror(errno));
        if (count == 0) return traits_type::eof();
        if (static_cast<std::uintmax_t>(count) > left_) fail("has more bytes than are allowed");
        left_ -= static_cast<std::uintmax_t>(count);
        setg(bytes_.data(), bytes_.data(), bytes_.data() + count);
        return traits_type::to_int_type(bytes_[0]);
    }

private:
    [[noreturn]] void fail(const std::string& why) const { throw InputError(name_ + ": " + why); }

    std::string name_;
    std::uintmax_t left_;  ///< bytes that may still come
    int file_ = -1;
    std::array<char, 1 << 16> bytes_{};
};

}  // namespace

// A stream that throws for a bad read hands on what its buffer has thrown
InputFile::InputFile(const std::string& name, std::uintmax_t largest, InputKind kind)
    : std::istream(nullptr), buffer_(std::make_unique<Buffer>(name, largest, kind)) {
    rdbuf(buffer_.get());
    exceptions(std::ios::badbit);
}

std::string read_text(const std::string& name, std::uintmax_t largest, InputKind kind) {
    InputFile in(name, largest, kind);
    return {std::istreambuf_iterator<char>(in), {}};
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

bool NumberedLines::next() {
    const LineEnd end = read_line(in, line, longest);
    if (end == LineEnd::None) return false;
    ++number;
    if (end == LineEnd::TooLong) fail("longer than " + std::to_string(longest) + " bytes");
    if (end == LineEnd::CutOff && !may_be_cut_off) fail("cut off: expected an end of line");
    return true;
}

std::string NumberedLines::place() const { return file + ":" + std::to_string(std::max(number, 1)); }

void NumberedLines::fail(const std::string& why) const { throw InputError(place() + ": " + why); }

}  // namespace drape
