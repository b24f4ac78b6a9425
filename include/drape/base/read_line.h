#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace drape {

/// How a line that was read ended: with its end, with the file, not within the length allowed, or never began.
enum class LineEnd { Whole, CutOff, TooLong, None };

/// Reads the next line, without its end; carriage returns before the end are no part of it. Never keeps more than
/// `longest` bytes, whatever the file is.
inline LineEnd read_line(std::istream& in, std::string& line, std::size_t longest) {
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
