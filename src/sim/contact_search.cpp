#include "drape/sim/contact_search.h"

#include <algorithm>

#include "drape/bounds/leaf_copies.h"
#include "drape/contact/node_contacts.h"

namespace drape {
namespace {

/// The one that is farthest beyond where it becomes possible, or nearest to it.
void take_worse(Crossing& worst, const Crossing& other) {
    const bool first = worst.radius == 0;
    if (first || 2 * other.distance - other.radius > 2 * worst.distance - worst.radius) worst = other;
}

}  // namespace

void ContactSearch::use(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x) {
    kernels_ = parameters.kernels;
    grid_ = grid;
    hierarchy_ = make_broad_phase(parameters, grid);
    audit_.reset();
    if (!parameters.search.none()) audit_.emplace(grid, kernels_);
    build_from(x);
}

void ContactSearch::build_from(const Points& x) {
    hierarchy_->build(x);
    built_from_present_ = true;
    queried_ = false;
}

void ContactSearch::build_from_way(const Points& before, const Points& x) {
    hierarchy_->build(before, x);
    sweeps_ = true;
    built_from_present_ = queried_ = false;
}

Crossing ContactSearch::worst_crossing(const Points& before, const Points& x, std::span<const Ball> balls,
                                       Real thickness) const {
    const Real cloth = largest_displacement(x, before, kernels_);
    Crossing worst;
    for (const Ball& ball : balls) {
        take_worse(worst, {ball.moved.norm() + cloth, ball.radius + thickness});
    }
    return worst;
}

Crossing ContactSearch::solid_crossing(const Points& before, const Points& x, std::span<const Solid> solids,
                                       Real thickness) const {
    const Real cloth = largest_displacement(x, before, kernels_);
    Crossing worst;
    for (const Solid& solid : solids) {
        const auto [low, high] = solid.shape->extent();
        take_worse(worst, {solid.moved.norm() + cloth, (high - low).minCoeff() / 2 + thickness});
    }
    return worst;
}

void ContactSearch::build(const Points& before, const Points& x, std::span<const Ball> balls,
                          const ContactSettings& contact) {
    const bool always = contact.continuous == Continuous::Always;
    crossing_ = always ? Crossing{} : worst_crossing(before, x, balls, contact.thickness);
    sweeps_ = always || (contact.continuous == Continuous::Auto && crossing_.possible());
    sweeps_ ? build_from_way(before, x) : build_from(x);
}

TraversalStats ContactSearch::traverse(std::span<const Ball> balls, Real thickness) {
    traversal_ = {};
    candidates_.resize(balls.size());
    for (std::size_t b = 0; b < balls.size(); ++b) {
        traversal_ += sweeps_ ? hierarchy_->query(grown(way_of(balls[b]), thickness), candidates_[b])
                              : hierarchy_->query(grown(balls[b], thickness), candidates_[b]);
        // In the same order whatever found them, so that contacts are answered in the same order
        std::ranges::sort(candidates_[b].cells);
    }
    queried_ = !sweeps_;
    return traversal_;
}

std::int64_t ContactSearch::narrow(const Points& before, const Points& x, std::span<const Ball> balls, Real thickness,
                                   Real longest_push, std::vector<Contact>& contacts) {
    contacts.clear();
    found_passing_ = false;
    std::int64_t touching = 0;
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const auto& [cells, stopped] = candidates_[b];
        const int number = static_cast<int>(b);
        if (sweeps_) {
            touching +=
                find_swept_contacts(grid_, before, x, balls[b], number, thickness, cells, impacts_, contacts, kernels_);
            continue;
        }
        touching += find_contacts(grid_, x, balls[b], number, thickness, cells, contacts, kernels_);
        find_node_contacts(grid_, x, balls[b], number, thickness, longest_push, stopped, contacts);
    }
    found_passing_ = sweeps_ && std::ranges::any_of(contacts, &Contact::of_impact);
    return traversal_.candidates - touching;
}

void ContactSearch::look_again(const Points& before, const Points& x, std::span<const Ball> balls, Real thickness,
                               std::vector<Contact>& contacts) {
    build_from_way(before, x);
    traverse(balls, thickness);
    narrow(before, x, balls, thickness, 0, contacts);
}

TraversalStats ContactSearch::meet_solids(const Points& before, const Points& x, std::span<const Solid> solids,
                                          const ContactSettings& contact, std::vector<Contact>& contacts) {
    TraversalStats stats;
    if (solids.empty()) return stats;
    const Real cloth = largest_displacement(x, before, kernels_);
    const auto is_swept = [&](const Solid& solid) {
        const bool may_pass = 2 * (cloth + solid.moved.norm()) > contact.thickness;
        return contact.continuous == Continuous::Always || (contact.continuous == Continuous::Auto && may_pass);
    };
    if (std::ranges::any_of(solids, is_swept) && !sweeps_) build_from_way(before, x);
    if (!sweeps_ && !built_from_present_) build_from(x);
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const Solid& solid = solids[s];
        const int number = static_cast<int>(s);
        stats += hierarchy_->query_near(solid, contact.thickness + solid.moved.norm(), near_);
        std::ranges::sort(near_.cells);
        if (is_swept(solid)) {
            solid_search_.find_swept(grid_, before, x, solid, number, contact.thickness, near_.cells, contacts);
        } else {
            solid_search_.find(grid_, x, solid, number, contact.thickness, near_.cells, contacts);
        }
    }
    return stats;
}

TraversalStats ContactSearch::meet_ground(const Points& x, Real height, Real thickness,
                                          std::vector<Contact>& contacts) {
    const bool asks = (built_from_present_ || sweeps_) && hierarchy_->levels() > 0;
    const TraversalStats stats = asks ? hierarchy_->query_below(height + thickness, low_) : TraversalStats{};
    // A pass in the order of memory is faster than picking more than some of the particles
    const bool picks = asks && 4 * stats.candidates < grid_.cells();
    if (picks) {
        find_ground_contacts(grid_, x, height, thickness, low_.cells, low_particles_, contacts);
    } else {
        find_ground_contacts(grid_, x, height, thickness, contacts);
    }
    return stats;
}

std::int64_t ContactSearch::false_contacts(const Points& x, std::span<const Ball> balls, Real thickness) {
    std::int64_t count = 0;
    for (std::size_t b = 0; audit_ && b < balls.size(); ++b) {
        count += audit_->false_contacts(x, balls[b], thickness, candidates_[b].stopped);
    }
    return count;
}

Real ContactSearch::missed_penetration(const Points& x, std::span<const Ball> balls, Real thickness) {
    return audit_ ? audit_->penetration(x, balls, thickness) : 0;
}

void ContactSearch::show(const Points& x, std::span<const Ball> balls, Real thickness) {
    if (!built_from_present_) build_from(x);
    if (queried_) return;
    candidates_.resize(balls.size());
    for (std::size_t b = 0; b < balls.size(); ++b) {
        hierarchy_->query(grown(balls[b], thickness), candidates_[b]);
    }
    queried_ = true;
}

TraversalStats ContactSearch::mark_pairs(const ContactSearch& other, Real margin, const FoldTest* folds,
                                         std::vector<LeafPair>& pairs) {
    return hierarchy_->query(*other.hierarchy_, margin, folds, pairs);
}

}  // namespace drape
