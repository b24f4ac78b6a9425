#pragma once

#include <filesystem>

#include "drape/base/stopwatch.h"

namespace drape {

/// Tells on standard error how far a run has come: in one line that is rewritten on a terminal, else in a line now and
/// then.
class Progress {
public:
    explicit Progress(int pictures);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Another picture was drawn.
    void count();

    /// Says how many there are, and where.
    void close(const std::filesystem::path& folder);

    /// Makes room on a terminal for something else to be said.
    void clear();

private:
    bool terminal_;
    bool shown_ = false;  ///< a line that is to be rewritten
    int all_, done_ = 0;
    double said_ = 0;  ///< when something was said last [s]
    Stopwatch watch_;
};

}  // namespace drape
