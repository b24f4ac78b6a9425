#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/detection.h"
#include "drape/scene/settings.h"

namespace drape {

/// Finds where one cloth touches the balls, stage by stage: build, traverse, narrow.
class ContactSearch {
public:
    /// Takes a new hierarchy, built from the present positions.
    /// @param x n x 3 [m]
    void use(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x);

    /// To be told whenever the positions have changed.
    void positions_changed() { built_from_present_ = false; }

    /// Builds the hierarchy for the end of a substep. What may meet within it is found from there by how far all moved,
    /// unless `contact.continuous` is never.
    void build(const MovingCloth& cloth, const ContactSettings& contact);

    /// Collects the candidates of each ball.
    /// @return what it has cost
    TraversalStats traverse(std::span<const Ball> balls, Real thickness);

    /// Tests the candidates exactly.
    /// @param longest_push of a node that stands for the cloth within it [m]
    /// @param rows receives what may touch, ball by ball, cells ascending
    /// @return how many candidate cells do not touch
    std::int64_t narrow(const MovingCloth& cloth, std::span<const Ball> balls, Real thickness, Real longest_push,
                        std::vector<ContactRow>& rows);

    /// What the last `traverse` has found of a ball.
    [[nodiscard]] const Candidates& candidates(std::size_t ball) const { return candidates_[ball]; }

    /// Whether the planes of a ball's contacts are those of the start of the substep.
    [[nodiscard]] bool looked_back(const Ball& ball, Real thickness) const {
        return reach(ball.moved, ball.radius + thickness) > 0;
    }

    /// Tests the cloth against a solid or the ground: what a hierarchy of the present positions has not pruned, or
    /// without one all of it.
    /// @param number of the body
    /// @param rows receives what may touch, cells ascending, after what is there
    /// @return what the traversal has cost; without one, all cells are candidates
    TraversalStats meet(const MovingCloth& cloth, const Body& body, int number, Real thickness,
                        std::vector<ContactRow>& rows);

    /// Tells what a limited search invents and what it lets through, by testing every cell; null for any other search.
    [[nodiscard]] SearchAudit* audit() { return audit_ ? &*audit_ : nullptr; }

    /// Makes the hierarchy fit to be drawn: as the last step searched it, or, where that did not, built from the
    /// present positions; its nodes marked by what the queries do to them. No contact depends on it.
    void show(const Points& x, std::span<const Ball> balls, Real thickness);

    /// A query marks its nodes.
    [[nodiscard]] BroadPhase& hierarchy() { return *hierarchy_; }
    [[nodiscard]] const BroadPhase& hierarchy() const { return *hierarchy_; }

private:
    void build_from(const Points& x);
    [[nodiscard]] Real reach(const Vec3& moved, Real room) const;

    Grid grid_{0, 0};
    Kernels kernels_ = Kernels::Vector;
    Copied<BroadPhase> hierarchy_;
    std::optional<SearchAudit> audit_;  ///< while the search is limited
    bool built_from_present_ = false;
    bool queried_ = false;     ///< since the last build
    bool looks_back_ = false;  ///< to the start of the substep, at what is fast
    Real moved_ = 0;           ///< by the particle that moved most within the substep, where it counts [m]
    TraversalStats traversal_;
    std::vector<Candidates> candidates_;  ///< of each ball
    Candidates near_;                     ///< a solid or the ground
    SolidSearch solid_search_;
};

}  // namespace drape
