#include "drape/sim/contact_search.h"

#include <algorithm>

#include "drape/bounds/leaf_copies.h"

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
    list_all_cells(grid, all_cells_);
    if (!parameters.search.none()) audit_.emplace(grid, kernels_);
    build_from(x);
}

void ContactSearch::build_from(const Points& x) {
    hierarchy_->build(x);
    built_from_present_ = true;
    queried_ = false;
}

Crossing ContactSearch::crossing(const MovingCloth& cloth, std::span<const Ball> balls, Real thickness) const {
    const Real moved = largest_displacement(cloth.x, cloth.before, kernels_);
    Crossing worst;
    for (const Ball& ball : balls) {
        take_worse(worst, {ball.moved.norm() + moved, ball.radius + thickness});
    }
    return worst;
}

Crossing ContactSearch::crossing(const MovingCloth& cloth, std::span<const Solid> solids, Real thickness) const {
    const Real moved = largest_displacement(cloth.x, cloth.before, kernels_);
    Crossing worst;
    for (const Solid& solid : solids) {
        const auto [low, high] = solid.shape->extent();
        take_worse(worst, {solid.moved.norm() + moved, (high - low).minCoeff() / 2 + thickness});
    }
    return worst;
}

void ContactSearch::build(const MovingCloth& cloth, const ContactSettings& contact) {
    build_from(cloth.x);
    looks_back_ = contact.continuous != Continuous::Never;
    moved_ = looks_back_ ? largest_displacement(cloth.x, cloth.before, kernels_) : 0;
}

Real ContactSearch::reach(const Vec3& moved, Real room) const {
    return looks_back_ ? reach_of(moved_ + moved.norm(), room) : Real(0);
}

TraversalStats ContactSearch::traverse(std::span<const Ball> balls, Real thickness) {
    traversal_ = {};
    candidates_.resize(balls.size());
    for (std::size_t b = 0; b < balls.size(); ++b) {
        // What was as near as the reach at the start may be farther by as much at the end
        const Real margin = thickness + 2 * reach(balls[b].moved, balls[b].radius + thickness);
        traversal_ += hierarchy_->query(grown(balls[b], margin), candidates_[b]);
        // In the same order whatever found them, so that contacts are answered in the same order
        std::ranges::sort(candidates_[b].cells);
    }
    queried_ = true;
    return traversal_;
}

std::int64_t ContactSearch::narrow(const MovingCloth& cloth, std::span<const Ball> balls, Real thickness,
                                   Real longest_push, std::vector<ContactRow>& rows) {
    std::int64_t touching = 0;
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const auto& [cells, stopped] = candidates_[b];
        const Ball& ball = balls[b];
        const SearchedBody body{static_cast<int>(b), thickness, reach(ball.moved, ball.radius + thickness)};
        touching += find_contacts(cloth, ball, body, cells, rows, kernels_);
        find_node_contacts(cloth, ball, body, longest_push, stopped, rows);
    }
    return traversal_.candidates - touching;
}

TraversalStats ContactSearch::meet_solid(const MovingCloth& cloth, const Solid& solid, int body, Real thickness,
                                         std::vector<ContactRow>& rows) {
    const Real near = reach(solid.moved, thickness);
    const auto distance = [&solid](const Vec3& p) { return solid.distance(p); };
    const TraversalStats stats = hierarchy_->query_near(distance, thickness + 2 * near, near_);
    std::ranges::sort(near_.cells);
    solid_search_.find(cloth, solid, {body, thickness, near}, near_.cells, rows);
    return stats;
}

TraversalStats ContactSearch::meet_ground(const MovingCloth& cloth, Real height, int body, Real thickness,
                                          std::vector<ContactRow>& rows) {
    if (!built_from_present_ || hierarchy_->levels() == 0) {
        find_ground_contacts(cloth, height, {body, thickness}, all_cells_, rows);
        return {};
    }
    const TraversalStats stats = hierarchy_->query_below(height + thickness, low_);
    std::ranges::sort(low_.cells);
    find_ground_contacts(cloth, height, {body, thickness}, low_.cells, rows);
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
