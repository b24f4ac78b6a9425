#include "drape/session/search_timer.h"

#include <algorithm>
#include <limits>

#include "drape/base/assert.h"

namespace drape {

namespace {

constexpr double interval = 1;  // s between two comparisons
constexpr int repetitions = 3;

bool can_compare(const FrameView& view, const BroadPhaseParameters& parameters) {
    const bool remembers = parameters.update == UpdateKind::Refit || parameters.update == UpdateKind::None;
    return !view.balls.empty() && parameters.volume != VolumeKind::Brute && parameters.search.none() && !remembers;
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
    if (!can_compare(view, broad_phase_of(*view.settings))) return std::nullopt;
    prepare(view);
    const auto least = [&](bool by_hierarchy) {
        double time = std::numeric_limits<double>::infinity();
        for (int r = 0; r < repetitions; ++r) {
            const Stopwatch watch;
            search(view, by_hierarchy);
            time = std::min(time, watch.seconds());
        }
        return time;
    };
    SearchTimes times{.hierarchy = least(true)};
    const std::size_t contacts = contacts_.size();
    times.brute_force = least(false);
    DRAPE_ASSERT(contacts_.size() == contacts);
    return times;
}

/// Hierarchies and lists are made where the scene has changed.
void SearchTimer::prepare(const FrameView& view) {
    BroadPhaseParameters parameters = broad_phase_of(*view.settings);
    const bool same =
        parameters == parameters_ && std::ranges::equal(cloths_, view.cloths, {}, &OfCloth::grid,
                                                        [](const ClothView& cloth) { return cloth.model.grid; });
    if (same) return;
    parameters_ = parameters;
    parameters.volume = VolumeKind::Brute;
    cloths_.clear();
    for (const ClothView& cloth : view.cloths) {
        OfCloth& own = cloths_.emplace_back();
        own.grid = cloth.model.grid;
        own.hierarchy.use(parameters_, own.grid, cloth.x);
        own.brute_force.use(parameters, own.grid, cloth.x);
    }
}

void SearchTimer::search(const FrameView& view, bool by_hierarchy) {
    ContactSettings contact = view.settings->contact;
    contact.continuous = Continuous::Never;
    contacts_.clear();
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        ContactSearch& searched = by_hierarchy ? cloths_[c].hierarchy : cloths_[c].brute_force;
        const Points& x = view.cloths[c].x;
        const MovingCloth cloth{cloths_[c].grid, x, x};
        searched.build(cloth, contact);
        searched.traverse(view.balls, contact.thickness);
        searched.narrow(cloth, view.balls, contact.thickness, 0, contacts_);
    }
}

}  // namespace drape
