#pragma once

#include <fmt/core.h>

#include <string>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"

namespace drape {

/// Reads a file line after line, never keeps more of one than it may have, and knows where it is.
class LineReader {
public:
    /// @param name of the file, for messages
    /// @param longest that a line may be [bytes]
    LineReader(std::istream& in, std::string name, std::size_t longest)
        : in_(in), name_(std::move(name)), longest_(longest) {}

    /// @throws InputError if the line is too long
    LineEnd next() {
        const LineEnd end = read_line(in_, line_, longest_);
        if (end != LineEnd::None) ++number_;
        if (end == LineEnd::TooLong) fail("too long: allowed {} bytes in a line", longest_);
        return end;
    }

    [[nodiscard]] const std::string& line() const { return line_; }
    [[nodiscard]] bool at_end() const { return in_.peek() == std::istream::traits_type::eof(); }
    [[nodiscard]] std::string where() const { return fmt::format("{}:{}: ", name_, number_); }

    /// @throws InputError that names the line
    template <class... Values>
    [[noreturn]] void fail(fmt::format_string<Values...> what, Values&&... values) const {
        throw InputError(where() + fmt::format(what, std::forward<Values>(values)...));
    }

private:
    std::istream& in_;
    std::string name_, line_;
    std::size_t longest_;
    int number_ = 0;
};

}  // namespace drape
