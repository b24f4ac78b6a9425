#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <streambuf>
#include <string>

namespace drape {

/// What is read as a file.
enum class InputKind {
    RegularOrOpen,  ///< also what the caller's shell has opened (`/dev/stdin`, `/dev/fd/N`), be it a pipe
    Regular
};

/// A file that is read as a stream of bytes. It never waits for somebody else to open the other end: pipes that are not
/// open already, devices and folders are refused.
/// What goes wrong later (a read error, more bytes than are allowed) is thrown by the read that meets it.
class InputFile : public std::istream {
public:
    /// @param largest most bytes that the file may have
    /// @throws InputError that names the file: cannot be read, a folder, a pipe, a device, too large
    explicit InputFile(const std::string& name, std::uintmax_t largest = UINTMAX_MAX,
                       InputKind kind = InputKind::RegularOrOpen);

private:
    std::unique_ptr<std::streambuf> buffer_;
};

/// A whole file. @throws InputError as `InputFile`
std::string read_text(const std::string& name, std::uintmax_t largest = UINTMAX_MAX,
                      InputKind kind = InputKind::RegularOrOpen);

/// How a line that was read ended: with its end, with the file, not within the length allowed, or never began.
enum class LineEnd { Whole, CutOff, TooLong, None };

/// Reads the next line, without its end; carriage returns before the end are no part of it. Never keeps more than
/// `longest` bytes, whatever the file is.
LineEnd read_line(std::istream& in, std::string& line, std::size_t longest);

/// The lines of a file one after the other, with the number of each for messages.
struct NumberedLines {
    std::istream& in;
    std::string file;             ///< as messages name it
    std::size_t longest;          ///< bytes that a line may have
    bool may_be_cut_off = false;  ///< the last line may lack its end
    std::string line = {};
    int number = 0;  ///< of the line, from 1

    /// Reads the next line, as `read_line`.
    /// @return false at the end of the file; messages still name the last line
    /// @throws InputError if the line is too long, or is cut off and may not be
    bool next();

    /// "FILE:NUMBER", and an error there. @throws InputError
    [[nodiscard]] std::string place() const;
    [[noreturn]] void fail(const std::string& why) const;
};

}  // namespace drape
