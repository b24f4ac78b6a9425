#pragma once

#include <cstdint>

namespace drape {

/// Where a session stands between the steps that it can go back to and those it knows already.
struct Timeline {
    std::int64_t oldest = 0;  ///< that it can go back to
    std::int64_t now = 0;
    std::int64_t newest = 0;  ///< of the run so far, or of the recording that is replayed
    double passed = 0;        ///< simulated time since the session began, resets included [s]
    double back = 0;          ///< from the present step to the newest; in a replay, as if no time step changed [s]
    double kept = 0;          ///< from the oldest to the newest; likewise [s]
    double bytes = 0;         ///< of memory that the past takes, about
    bool replay = false;      ///< what lies ahead comes from a recording

    [[nodiscard]] bool is_live() const { return now == newest; }
};

}  // namespace drape
