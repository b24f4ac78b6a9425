#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "drape/base/input_error.h"

namespace drape {

/// A text file that is opened before the work and checked after it; without a name it takes nothing.
class OutputFile {
public:
    /// @throws RunError if it cannot be written
    explicit OutputFile(const std::string& name) : name_(name) {
        if (name_.empty()) return;
        out_.open(name_, std::ios::binary | std::ios::trunc);
        if (!out_) throw RunError(name_ + ": cannot be written");
    }

    [[nodiscard]] bool wanted() const { return !name_.empty(); }
    std::ostream& stream() { return out_; }

    /// @throws RunError if not everything reached the file
    void close() {
        if (!wanted()) return;
        out_.close();
        if (!out_) throw RunError(name_ + ": could not be written whole");
    }

private:
    std::string name_;
    std::ofstream out_;
};

/// To be called before two files are opened.
/// @param options for the message: "--state and --stats"
/// @throws InputError if both names are of one file, which would take both texts at once; devices may
inline void check_apart(const std::string& options, const std::string& one, const std::string& other) {
    namespace files = std::filesystem;
    if (one.empty() || other.empty()) return;
    std::error_code ignored;
    const bool device = files::exists(one, ignored) && !files::is_regular_file(one, ignored);
    const auto place = [&](const std::string& name) { return files::weakly_canonical(files::absolute(name), ignored); };
    if (device || place(one) != place(other)) return;
    throw InputError(options + " " + one + ": allowed two different files");
}

}  // namespace drape
