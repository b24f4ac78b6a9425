#include "crossing_news.h"

namespace drape {

std::string CrossingNews::take(const Simulation& simulation) {
    const std::int64_t starts = simulation.report().crossing.starts;
    if (starts <= told_) return {};
    told_ = starts;
    return simulation.crossing_warning();
}

}  // namespace drape
