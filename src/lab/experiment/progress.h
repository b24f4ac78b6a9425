#pragma once

#include <cstddef>
#include <string>

#include "drape/base/stopwatch.h"

namespace drape {

/// Tells on standard error how far a long run is and how long it will take: on a terminal in one line that changes,
/// elsewhere in a new line now and then.
class Progress {
public:
    /// @param total of the parts to do now
    explicit Progress(std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A part is done.
    void advance();

private:
    Stopwatch watch_;
    std::size_t total_, done_ = 0;
    double told_ = 0;  ///< when it was last told [s]
    bool terminal_;
};

/// A time that is left, as people say it: "2 min", "40 s".
std::string rough_time(double seconds);

}  // namespace drape
