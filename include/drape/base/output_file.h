#pragma once

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

}  // namespace drape
