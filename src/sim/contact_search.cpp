#include "drape/sim/contact_search.h"

#include <algorithm>

#include "drape/bounds/leaf_copies.h"

namespace drape {

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
        std::ranges::sort(candidates_[b].stopped, {}, &StoppedNode::cell);
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

TraversalStats ContactSearch::meet(const MovingCloth& cloth, const Body& body, int number, Real thickness,
                                   std::vector<ContactRow>& rows) {
    const Real near = body.is_ground() ? Real(0) : reach(body.moved, thickness);
    TraversalStats stats;
    if (built_from_present_) {
        const auto distance = [&body](const Vec3& p) { return body.measure(p).distance; };
        stats = hierarchy_->query_near(distance, thickness + 2 * near, near_);
        std::ranges::sort(near_.cells);
    } else {
        list_all_cells(grid_, near_.cells);
    }
    if (body.is_ground()) {
        find_ground_contacts(cloth, body.centre.y(), {number, thickness}, near_.cells, rows);
    } else {
        solid_search_.find(cloth, *body.solid, {number, thickness, near}, near_.cells, rows);
    }
    return stats;
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

}  // namespace drape
