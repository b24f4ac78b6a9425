#pragma once

#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/detection.h"
#include "drape/scene/settings.h"

namespace drape {

/// Finds where one cloth touches bodies, stage by stage: build, traverse, narrow.
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

    /// Collects the candidates of a body: what a hierarchy of the present positions has not pruned. For a solid or the
    /// ground there may be none, and all cells are candidates.
    /// @param number of the body
    /// @return what it has cost
    TraversalStats traverse(const Body& body, std::size_t number, Real thickness);

    /// Tests them exactly.
    /// @param longest_push of a node that stands for the cloth within it [m]
    /// @param rows receives what may touch, cells ascending, after what is there
    /// @return how many of the candidate cells touch, if it is a ball
    std::int64_t narrow(const MovingCloth& cloth, const Body& body, std::size_t number, Real thickness,
                        Real longest_push, std::vector<ContactRow>& rows);

    /// What the last `traverse` has found of a body.
    [[nodiscard]] const Candidates& candidates(std::size_t body) const { return candidates_[body]; }

    /// As `SearchedBody` has it: where it is above 0, the planes of a body's contacts are those of the substep's start.
    [[nodiscard]] Real reach(const Body& body, Real thickness) const;

    /// Makes the hierarchy fit to be drawn: as the last step searched it, or, where that did not, built from the
    /// present positions; its nodes marked by what the queries do to them. No contact depends on it.
    void show(const Points& x, std::span<const Ball> balls, Real thickness);

    /// A query marks its nodes.
    [[nodiscard]] BroadPhase& hierarchy() { return *hierarchy_; }
    [[nodiscard]] const BroadPhase& hierarchy() const { return *hierarchy_; }

private:
    void build_from(const Points& x);

    Grid grid_{0, 0};
    Kernels kernels_ = Kernels::Vector;
    Copied<BroadPhase> hierarchy_;
    bool built_from_present_ = false;
    bool queried_ = false;                ///< since the last build
    bool looks_back_ = false;             ///< to the start of the substep, at what is fast
    Real moved_ = 0;                      ///< by the particle that moved most within the substep, where it counts [m]
    std::vector<Candidates> candidates_;  ///< of each body
    SolidSearch solid_search_;
};

}  // namespace drape
