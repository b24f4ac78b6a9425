#pragma once

#include <ext/stdio_filebuf.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "drape/base/unfinished_file.h"

namespace drape {

/// A file that is opened before the work and checked after it; without a name it takes nothing. What was there before
/// stays until all is written: see `UnfinishedFile`. A device, a FIFO and the program's own standard output are written
/// directly.
class OutputFile {
public:
    using LeftOver = UnfinishedFile::LeftOver;

    /// @throws RunError if it cannot be written
    explicit OutputFile(const std::string& name, LeftOver left_over = LeftOver::Remove);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] bool wanted() const { return !name_.empty(); }
    std::ostream& stream() { return out_; }

    /// Where a killed run's file has gone, with `LeftOver::Keep`; empty if there was none.
    [[nodiscard]] std::filesystem::path set_aside() const;

    /// @throws RunError if not everything that was written until now reached the file
    void flush();

    /// Takes back all that was written from a byte on, and goes on there.
    /// @return false if this cannot be done to what it writes (a device, a FIFO)
    /// @throws RunError if not everything that was written until now reached the file
    [[nodiscard]] bool cut_at(std::int64_t byte);

    /// Ends the file, and gives it its name.
    /// @throws RunError if not everything reached it: what was there before is there still
    void close();

    /// The same, unless a file has that name by now.
    /// @return false if one has: it stays
    /// @throws RunError
    [[nodiscard]] bool close_if_free();

private:
    /// Remembers why it could not write, which a stream forgets.
    class Buffer : public __gnu_cxx::stdio_filebuf<char> {
    public:
        using stdio_filebuf::stdio_filebuf;
        [[nodiscard]] std::string reason() const;

    protected:
        int_type overflow(int_type c) override;
        std::streamsize xsputn(const char* text, std::streamsize size) override;

    private:
        int error_ = 0;
    };

    void end_stream();

    std::string name_;
    std::optional<UnfinishedFile> unfinished_;  ///< nothing where it is written directly
    std::optional<Buffer> buffer_;
    std::ostream out_{nullptr};
};

/// A file that a command line names.
struct NamedFile {
    enum class Use { Read, Write };

    std::string option;          ///< that names it: "--state"
    std::filesystem::path path;  ///< empty: none
    Use use = Use::Write;
};

/// To be called before any of them is opened.
/// @throws InputError naming two of them that are one file, by whatever names and links, if one of these is written;
///         devices may be
void check_apart(const std::vector<NamedFile>& files);

}  // namespace drape
