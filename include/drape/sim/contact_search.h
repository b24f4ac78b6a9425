#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/contact.h"
#include "drape/contact/search_audit.h"
#include "drape/contact/solid_contacts.h"
#include "drape/sim/settings.h"

namespace drape {

/// Whether a ball may get through the cloth in a substep, seen from its start and end alone: a ball of radius r that is
/// outside must come as far as r before its centre is on the other side. Half of that counts. The same for a solid.
struct Crossing {
    Real distance = 0;  ///< by which it and cloth can have come nearer, at most [m]
    Real radius = 0;    ///< of the ball, or half the shortest side of the solid's bounding box; with the thickness [m]

    [[nodiscard]] bool possible() const { return 2 * distance > radius; }
};

/// Finds where one cloth touches the balls, stage by stage: build, traverse, narrow.
class ContactSearch {
public:
    /// Takes a new hierarchy, built from the present positions.
    /// @param x n x 3 [m]
    void use(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x);

    /// To be told whenever the positions have changed.
    void positions_changed() { built_from_present_ = sweeps_ = false; }

    /// Builds the hierarchy for the end of a substep, or for all of it where its way is to be tested.
    /// @param before positions at its start, n x 3 [m]
    void build(const Points& before, const Points& x, std::span<const Ball> balls, const ContactSettings& contact);

    /// With a ball in the last substep, unless all of its way was tested without asking.
    [[nodiscard]] const Crossing& crossing() const { return crossing_; }

    /// With a solid, likewise.
    /// @param before, x positions at the start and at the end of the substep, n x 3 [m]
    [[nodiscard]] Crossing solid_crossing(const Points& before, const Points& x, std::span<const Solid> solids,
                                          Real thickness) const;

    /// Collects the candidates of each ball.
    /// @return what it has cost
    TraversalStats traverse(std::span<const Ball> balls, Real thickness);

    /// Tests the candidates exactly.
    /// @param longest_push of a node that stands for the cloth within it [m]
    /// @param contacts receives what touches, ball by ball, cells ascending; cleared first
    /// @return how many candidate cells do not touch
    std::int64_t narrow(const Points& before, const Points& x, std::span<const Ball> balls, Real thickness,
                        Real longest_push, std::vector<Contact>& contacts);

    /// Whether the last test has found something that has passed a ball, or has come past its middle.
    [[nodiscard]] bool found_passing() const { return found_passing_; }

    /// Builds, traverses and tests again, for the whole substep as it is after the response.
    /// @param contacts as `narrow` has it
    void look_again(const Points& before, const Points& x, std::span<const Ball> balls, Real thickness,
                    std::vector<Contact>& contacts);

    /// Tests the cloth against solids, and builds the hierarchy for it where that is not done yet. The whole substep is
    /// tested as `contact.continuous` says; under auto where cloth and solid may come nearer by half the thickness.
    /// @param contacts receives what touches, solid by solid, cells ascending, after what is there
    TraversalStats meet_solids(const Points& before, const Points& x, std::span<const Solid> solids,
                               const ContactSettings& contact, std::vector<Contact>& contacts);

    /// Tests the cloth against the ground: where the present hierarchy holds it, what that has not pruned, else all of
    /// it.
    /// @param contacts receives what touches, particles ascending, after what is there
    /// @return what the traversal has cost; zero without one
    TraversalStats meet_ground(const Points& x, Real height, Real thickness, std::vector<Contact>& contacts);

    /// What a limited search invents and what it lets through, by testing every cell; nothing for any other search.
    /// @return contacts of nodes in which no triangle touches
    std::int64_t false_contacts(const Points& x, std::span<const Ball> balls, Real thickness);
    /// @return largest depth of any triangle [m]
    Real missed_penetration(const Points& x, std::span<const Ball> balls, Real thickness);

    /// Makes the hierarchy fit to be drawn: as the last step searched it, or, where that did not, built from the
    /// present positions; its nodes marked by what the queries do to them. No contact depends on it.
    void show(const Points& x, std::span<const Ball> balls, Real thickness);

    /// Marks the nodes of the shown hierarchy by what a search against another one, or itself, does to them as well.
    /// @param folds, pairs as `BroadPhase::query` has them @pre `show` was called for both
    TraversalStats mark_pairs(const ContactSearch& other, Real margin, const FoldTest* folds,
                              std::vector<LeafPair>& pairs);

    [[nodiscard]] const BroadPhase& hierarchy() const { return *hierarchy_; }

private:
    [[nodiscard]] Crossing worst_crossing(const Points& before, const Points& x, std::span<const Ball> balls,
                                          Real thickness) const;
    void build_from_way(const Points& before, const Points& x);
    void build_from(const Points& x);

    Grid grid_{0, 0};
    Kernels kernels_ = Kernels::Vector;
    Copied<BroadPhase> hierarchy_;
    std::optional<SearchAudit> audit_;  ///< while the search is limited
    Crossing crossing_;
    bool built_from_present_ = false;
    bool queried_ = false;        ///< since the last build
    bool sweeps_ = false;         ///< the last build was for the whole substep
    bool found_passing_ = false;  ///< by the last test
    std::vector<TriangleImpact> impacts_;
    TraversalStats traversal_;
    std::vector<Candidates> candidates_;  ///< of each ball
    Candidates low_;                      ///< near the ground
    Candidates near_;                     ///< a solid
    SolidSearch solid_search_;
    std::vector<CellRun> low_particles_;
};

}  // namespace drape
