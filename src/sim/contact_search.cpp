#include "drape/sim/contact_search.h"

#include <algorithm>

#include "drape/bounds/displacement.h"

namespace drape {

void ContactSearch::use(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x) {
    kernels_ = parameters.kernels;
    grid_ = grid;
    hierarchy_ = make_broad_phase(parameters, grid);
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
    moved_ = looks_back_ ? largest_displacement(cloth.x, cloth.before) : 0;
}

Real ContactSearch::reach(const Body& body, Real thickness) const {
    if (!looks_back_ || body.is_ground()) return 0;
    // At half a ball's radius and thickness, or the thickness beside a solid, neither is on the wrong side of the other
    const Real nearer = moved_ + body.moved.norm();
    return 2 * nearer > body.radius + thickness ? nearer : Real(0);
}

TraversalStats ContactSearch::traverse(const Body& body, std::size_t number, Real thickness) {
    if (number >= candidates_.size()) candidates_.resize(number + 1);
    auto& [cells, stopped] = candidates_[number];
    // What was as near as the reach at the start may be farther by as much at the end
    const Real margin = thickness + 2 * reach(body, thickness);
    TraversalStats stats;
    if (body.is_ball()) {
        stats = hierarchy_->query(grown(body, margin), candidates_[number]);
        queried_ = true;
    } else if (built_from_present_) {
        const auto distance = [&body](const Vec3& p) { return body.measure(p).distance; };
        stats = hierarchy_->query_near(distance, margin, candidates_[number]);
    } else {
        cells.assign(1, all_cells(grid_));
    }
    // In the same order whatever found them, so that contacts are answered in the same order
    std::ranges::sort(cells, {}, &CellRange::first);
    std::ranges::sort(stopped, {}, &StoppedNode::cell);
    return stats;
}

std::int64_t ContactSearch::narrow(const MovingCloth& cloth, const Body& body, std::size_t number, Real thickness,
                                   Real longest_push, std::vector<ContactRow>& rows) {
    const auto& [cells, stopped] = candidates_[number];
    const SearchedBody searched{static_cast<int>(number), thickness, reach(body, thickness)};
    if (body.is_ball()) {
        const std::int64_t touching = find_contacts(cloth, body, searched, cells, rows, kernels_);
        find_node_contacts(cloth, body, searched, longest_push, stopped, rows);
        return touching;
    }
    if (body.is_ground()) {
        find_ground_contacts(cloth, body.centre.y(), searched, cells, rows);
    } else {
        solid_search_.find(cloth, *body.solid, searched, cells, rows);
    }
    return 0;
}

void ContactSearch::show(const Points& x, std::span<const Ball> balls, Real thickness) {
    if (!built_from_present_) build_from(x);
    if (queried_) return;
    Candidates found;
    for (const Ball& ball : balls) hierarchy_->query(grown(ball, thickness), found);
    queried_ = true;
}

}  // namespace drape
