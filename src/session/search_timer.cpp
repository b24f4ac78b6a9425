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
constexpr int repetitions = 3;
constexpr double enough = 0.002;  // s after which a search is not repeated, so that the window hardly waits

/// Pairs of cells of all cloths that brute force may test here: more of them would hold up the window.
constexpr double most_pairs = 1e7;

bool searches_pairs(const FrameView& view) {
    double cells = 0;
    for (const ClothView& cloth : view.cloths) cells += cloth.model.grid.cells();
    return view.settings->contact.self && cells * cells / 2 <= most_pairs;
}

bool can_compare(const FrameView& view, const BroadPhaseParameters& parameters) {
    const bool remembers = parameters.update == UpdateKind::Refit || parameters.update == UpdateKind::None;
    const bool searches = !view.balls.empty() || searches_pairs(view);
    return searches && parameters.volume != VolumeKind::Brute && parameters.search.none() && !remembers;
}

/// The shortest of some runs [s].
template <class Run>
double least_time(Run run) {
    double least = std::numeric_limits<double>::infinity();
    const Stopwatch all;
    for (int done = 0; done == 0 || (done < repetitions && all.seconds() < enough); ++done) {
        const Stopwatch watch;
        run();
        least = std::min(least, watch.seconds());
    }
    return least;
}

/// What a search finds, and by how many tests.
struct Found {
    std::vector<ContactRow> contacts;
    std::size_t pairs = 0;
    double tests = 0;
    void add(const TraversalStats& traversal) {
        tests += static_cast<double>(traversal.volume_tests + traversal.candidates);
    }
};

/// What it takes to search all cloths for all balls [s].
double ball_search_time(const FrameView& view, const BroadPhaseParameters& parameters, Found& found) {
    ContactSettings contact = view.settings->contact;
    contact.continuous = Continuous::Never;
    std::vector<ContactSearch> searches(view.cloths.size());
    for (std::size_t c = 0; c < searches.size(); ++c) {
        searches[c].use(parameters, view.cloths[c].model.grid, view.cloths[c].x);
    }
    return least_time([&] {
        found = {};
        for (std::size_t c = 0; c < searches.size(); ++c) {
            const Points& x = view.cloths[c].x;
            const MovingCloth cloth{view.cloths[c].model.grid, x, x};
            searches[c].build(cloth, contact);
            for (std::size_t b = 0; b < view.balls.size(); ++b) {
                const Body ball = body_of(view.balls[b], contact);
                found.add(searches[c].traverse(ball, b, contact.thickness));
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
    const double time = least_time([&] {
        search.forget();
        search.find(cloths, response_of(*view.settings).pair_thickness);
    });
    found.pairs = search.pairs().size();
    found.add(search.report().traversal);
    return time;
}

double search_time(const FrameView& view, const BroadPhaseParameters& parameters, Found& found) {
    const double balls = ball_search_time(view, parameters, found);
    return searches_pairs(view) ? balls + pair_search_time(view, parameters, found) : balls;
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
    Found by_hierarchy, by_brute_force;
    SearchTimes times{.hierarchy = search_time(view, parameters, by_hierarchy)};
    parameters.volume = VolumeKind::Brute;
    times.brute_force = search_time(view, parameters, by_brute_force);
    DRAPE_ASSERT(by_hierarchy.contacts.size() == by_brute_force.contacts.size());
    DRAPE_ASSERT(by_hierarchy.pairs == by_brute_force.pairs);
    times.tests = by_hierarchy.tests;
    times.tests_of_brute_force = by_brute_force.tests;
    return times;
}

}  // namespace drape
