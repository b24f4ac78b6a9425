#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "drape/base/stopwatch.h"
#include "drape/sim/frame_view.h"

namespace drape {

/// Compares the hierarchy with brute force now and then, on the state that is shown and with hierarchies of its own:
/// the simulation does not notice. For the window alone, since it costs all tests of brute force.
class SearchTimer {
public:
    /// The median of the last five comparisons of a run with the same settings of contact; the next is made where a
    /// second has passed and something has moved. Null where none can be made.
    const SearchTimes* look(const FrameView& view);

    /// Searches every cloth for every ball, and for cloth near cloth where `contact.self` is on and there are few
    /// enough cells to pair them all, both ways, and takes the fastest of some runs. What is near is found
    /// from nothing, where a simulation keeps a list of it for some steps.
    /// @return nothing without anything to search for or a hierarchy, under a limit of the search, and for an update
    /// that depends on the steps before (refit, none): what that costs shows in a run only
    static std::optional<SearchTimes> measure(const FrameView& view);

private:
    std::optional<Stopwatch> watch_;  ///< since the last comparison
    std::deque<SearchTimes> last_;
    SearchTimes median_;       ///< of them
    std::string scene_;        ///< that they are of
    ContactSettings contact_;  ///< with which they were made
    std::int64_t step_ = -1;   ///< of the last comparison
};

}  // namespace drape
