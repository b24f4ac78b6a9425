#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drape/sim/command.h"

namespace drape {

/// A stop of the tour: a scene with some settings changed, what to look at in it, and where the code explains it.
struct TourStop {
    std::string_view title;
    std::string_view scene;
    std::string_view changes;  ///< "name=value,name=value", see `split_assignments`
    std::string_view versus;   ///< what it is compared with, likewise; empty: nothing
    std::string_view look;     ///< what to look at
    std::string_view try_it;   ///< what to do
    std::string_view file;     ///< that explains it
    double time;               ///< simulated, at which a picture of it tells the most [s]
};

/// The stops in their order.
std::span<const TourStop> tour_stops();

/// What brings a session to a stop: its scene and its comparison, and no other one; then its changes.
std::vector<Command> commands_of(const TourStop& stop);

/// The tour as a page in Markdown, with the pictures that `drape-capture --tour` makes, in a folder `tour` beside it.
std::string tour_page();

}  // namespace drape
