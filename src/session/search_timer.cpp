#include "drape/session/search_timer.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "drape/base/assert.h"
#include "drape/sim/contact_search.h"
#include "drape/sim/self_search.h"

namespace drape {

namespace {

constexpr double interval = 1;  // s between two comparisons
constexpr std::size_t kept = 5;
constexpr double enough = 0.002;  // s for which a search is repeated

/// Pairs of cells of all cloths that brute force may test here: more of them would hold up the window.
constexpr double max_pairs = 5e6;

bool searches_pairs(const FrameView& view) {
    double cells = 0;
    for (const ClothView& cloth : view.cloths) cells += cloth.model.grid.cells();
    return view.settings->contact.self && cells * cells / 2 <= max_pairs;
}

bool can_compare(const FrameView& view, const BroadPhaseParameters& parameters) {
    const bool remembers = parameters.update == UpdateKind::Refit || parameters.update == UpdateKind::None;
    const bool searches = !view.balls.empty() || searches_pairs(view);
    return searches && parameters.volume != VolumeKind::Brute && parameters.search.none() && !remembers;
}

/// The shortest of some runs [s].
template <class Run>
double shortest_time(Run run) {
    double shortest = std::numeric_limits<double>::infinity();
    const Stopwatch all;
    do {
        const Stopwatch watch;
        run();
        shortest = std::min(shortest, watch.seconds());
    } while (all.seconds() < enough);
    return shortest;
}

/// What a search finds, and what it costs.
struct Found {
    std::vector<ContactRow> contacts;
    std::size_t pairs = 0;
    TraversalStats traversal;
    [[nodiscard]] double tests() const { return static_cast<double>(traversal.volume_tests + traversal.candidates); }
};

/// What it takes to search all cloths for all balls [s].
double ball_search_time(const FrameView& view, const BroadPhaseParameters& parameters, Found& found) {
    ContactSettings contact = view.settings->contact;
    contact.continuous = Continuous::Never;
    std::vector<ContactSearch> searches(view.cloths.size());
    for (std::size_t c = 0; c < searches.size(); ++c) {
        searches[c].use(parameters, view.cloths[c].model.grid, view.cloths[c].x);
    }
    return shortest_time([&] {
        found = {};
        for (std::size_t c = 0; c < searches.size(); ++c) {
            const Points& x = view.cloths[c].x;
            const MovingCloth cloth{view.cloths[c].model.grid, x, x};
            searches[c].build(cloth, contact);
            for (std::size_t b = 0; b < view.balls.size(); ++b) {
                const Body ball = body_of(view.balls[b], contact);
                found.traversal += searches[c].traverse(ball, b, contact.thickness);
                searches[c].narrow(cloth, ball, b, contact.thickness, 0, found.contacts);
            }
        }
    });
}

/// What it takes to find all cloth that is near cloth, from nothing [s].
double pair_search_time(const FrameView& view, const BroadPhaseParameters& parameters, Found& found) {
    std::vector<ClothState> states;
    for (const ClothView& cloth : view.cloths) states.push_back({.x = cloth.x, .v = {}});
    std::vector<ClothInContact> cloths;
    for (std::size_t c = 0; c < states.size(); ++c) {
        cloths.push_back({view.cloths[c].model, view.cloths[c].previous, states[c]});
    }
    SelfSearch search;
    search.use(parameters, cloths);
    const double time = shortest_time([&] {
        search.forget();
        search.find(cloths, response_of(*view.settings).pair_thickness);
    });
    found.pairs = search.pairs().size();
    found.traversal += search.report().traversal;
    return time;
}

double search_time(const FrameView& view, const BroadPhaseParameters& parameters, Found& found) {
    const double balls = ball_search_time(view, parameters, found);
    return searches_pairs(view) ? balls + pair_search_time(view, parameters, found) : balls;
}

/// The one whose ratio is in the middle.
SearchTimes median_of(std::vector<SearchTimes> times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end(),
                     [](const SearchTimes& a, const SearchTimes& b) { return a.speed_up() < b.speed_up(); });
    return *middle;
}

}  // namespace

const SearchTimes* SearchTimer::look(const FrameView& view) {
    const StepReport& report = *view.report;
    if (view.scene != scene_ || view.settings->contact != contact_ || report.step < step_) {
        last_.clear(), watch_.reset();
        scene_ = view.scene, contact_ = view.settings->contact;
    }
    if (!watch_ || (report.step != step_ && !report.asleep && watch_->seconds() >= interval)) {
        if (const auto times = measure(view)) last_.push_back(*times);
        if (last_.size() > kept) last_.pop_front();
        if (!last_.empty()) median_ = median_of({last_.begin(), last_.end()});
        step_ = report.step;
        watch_.emplace();
    }
    return last_.empty() ? nullptr : &median_;
}

std::optional<SearchTimes> SearchTimer::measure(const FrameView& view) {
    BroadPhaseParameters parameters = broad_phase_of(*view.settings);
    if (!can_compare(view, parameters)) return std::nullopt;
    Found by_hierarchy, by_brute_force;
    const double hierarchy = search_time(view, parameters, by_hierarchy);
    parameters.volume = VolumeKind::Brute;
    const double brute_force = search_time(view, parameters, by_brute_force);
    DRAPE_ASSERT(by_hierarchy.contacts.size() == by_brute_force.contacts.size());
    DRAPE_ASSERT(by_hierarchy.pairs == by_brute_force.pairs);
    return SearchTimes{hierarchy, brute_force, by_hierarchy.tests(), by_brute_force.tests()};
}

}  // namespace drape
