#pragma once

#include <cstdint>

namespace drape {

/// Where a session stands between the steps that it can go back to and those it knows already.
struct Timeline {
    std::int64_t oldest = 0;  ///< that it can go back to
    std::int64_t now = 0;
    std::int64_t newest = 0;  ///< of the run so far, or of the recording that is replayed
    double dt = 0;            ///< of a step [s]
    double bytes = 0;         ///< of memory that the past takes, about
    bool replay = false;      ///< what lies ahead comes from a recording

    [[nodiscard]] bool is_live() const { return now == newest; }
};

}  // namespace drape
