#include "drape/render/tour_hint.h"

#include <string>

#include "drape/sim/tour.h"

namespace drape {

std::vector<KeyHelp> tour_hint(std::size_t stop) {
    const auto stops = tour_stops();
    const TourStop& now = stops[stop];
    return {{std::to_string(stop + 1) + " of " + std::to_string(stops.size()), std::string(now.title)},
            {"See", std::string(now.look)},
            {"Try", std::string(now.try_it)},
            {"Read", std::string(now.file)},
            {"F1, F2, Esc", "Next stop, previous stop, end of the tour"}};
}

}  // namespace drape
