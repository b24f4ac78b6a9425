#include "drape/session/search_timer.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "drape/base/assert.h"
#include "drape/sim/contact_search.h"

namespace drape {

namespace {

constexpr double interval = 1;  // s between two comparisons
constexpr int repetitions = 3;

bool can_compare(const FrameView& view, const BroadPhaseParameters& parameters) {
    const bool remembers = parameters.update == UpdateKind::Refit || parameters.update == UpdateKind::None;
    return !view.balls.empty() && parameters.volume != VolumeKind::Brute && parameters.search.none() && !remembers;
}

/// What the fastest search of all cloths takes [s].
/// @param contacts receives what it finds
double search_time(const FrameView& view, const BroadPhaseParameters& parameters, std::vector<ContactRow>& contacts) {
    ContactSettings contact = view.settings->contact;
    contact.continuous = Continuous::Never;
    std::vector<ContactSearch> searches(view.cloths.size());
    for (std::size_t c = 0; c < searches.size(); ++c) {
        searches[c].use(parameters, view.cloths[c].model.grid, view.cloths[c].x);
    }
    double least = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        const Stopwatch watch;
        contacts.clear();
        for (std::size_t c = 0; c < searches.size(); ++c) {
            const Points& x = view.cloths[c].x;
            const MovingCloth cloth{view.cloths[c].model.grid, x, x};
            searches[c].build(cloth, contact);
            for (std::size_t b = 0; b < view.balls.size(); ++b) {
                const Body ball = body_of(view.balls[b], contact);
                searches[c].traverse(ball, b, contact.thickness);
                searches[c].narrow(cloth, ball, b, contact.thickness, 0, contacts);
            }
        }
        least = std::min(least, watch.seconds());
    }
    return least;
}

}  // namespace

const SearchTimes* SearchTimer::look(const FrameView& view) {
    if (!watch_ || watch_->seconds() >= interval) {
        times_ = measure(view);
        watch_.emplace();
    }
    return times_ ? &*times_ : nullptr;
}

std::optional<SearchTimes> SearchTimer::measure(const FrameView& view) {
    BroadPhaseParameters parameters = broad_phase_of(*view.settings);
    if (!can_compare(view, parameters)) return std::nullopt;
    std::vector<ContactRow> by_hierarchy, by_brute_force;
    SearchTimes times{.hierarchy = search_time(view, parameters, by_hierarchy)};
    parameters.volume = VolumeKind::Brute;
    times.brute_force = search_time(view, parameters, by_brute_force);
    DRAPE_ASSERT(by_hierarchy.size() == by_brute_force.size());
    return times;
}

}  // namespace drape
