#include "drape/session/search_timer.h"

#include "drape/contact/detection.h"

#include <algorithm>

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
    SearchTimes times;
    const auto least = [&](double& time, std::int64_t& contacts, bool by_hierarchy) {
        for (int r = 0; r < repetitions; ++r) {
            const Stopwatch watch;
            search(view, by_hierarchy);
            const double passed = watch.seconds();
            time = r == 0 ? passed : std::min(time, passed);
        }
        contacts = static_cast<std::int64_t>(contacts_.size());
    };
    least(times.hierarchy, times.contacts, true);
    least(times.brute_force, times.contacts_by_brute_force, false);
    return times;
}

/// Hierarchies and lists are made where the scene has changed.
void SearchTimer::prepare(const FrameView& view) {
    const BroadPhaseParameters parameters = broad_phase_of(*view.settings);
    const bool same =
        parameters == parameters_ && std::ranges::equal(cloths_, view.cloths, {}, &OfCloth::grid,
                                                        [](const ClothView& cloth) { return cloth.model.grid; });
    if (same) return;
    parameters_ = parameters;
    cloths_.clear();
    for (const ClothView& cloth : view.cloths) {
        const Grid& grid = cloth.model.grid;
        cloths_.push_back({grid, make_broad_phase(parameters, grid), {}});
        list_all_cells(grid, cloths_.back().all_cells);
    }
}

void SearchTimer::search(const FrameView& view, bool by_hierarchy) {
    const Real thickness = view.settings->contact.thickness;
    contacts_.clear();
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        const auto& [grid, hierarchy, all_cells] = cloths_[c];
        const Points& x = view.cloths[c].x;
        if (by_hierarchy) hierarchy->build(x);
        for (std::size_t b = 0; b < view.balls.size(); ++b) {
            const Ball& ball = view.balls[b];
            if (by_hierarchy) hierarchy->query(grown(ball, thickness), found_);
            find_contacts({grid, x, x}, ball, {static_cast<int>(b), thickness}, by_hierarchy ? found_.cells : all_cells,
                          contacts_, parameters_.kernels);
        }
    }
}

}  // namespace drape
