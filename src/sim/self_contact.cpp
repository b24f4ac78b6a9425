#include "drape/sim/self_contact.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// The side of a leaf where none is given: a pair of leaves is tested cell by cell.
constexpr int pair_leaf_cells = 4;

/// Of the thickness, that cloth keeps from cloth whatever presses it.
constexpr Real of_thickness_kept = Real(1e-3);

}  // namespace

void SelfContact::use(const Settings& settings, std::span<const ClothModel* const> models,
                      std::span<const Points* const> x) {
    on_ = settings.contact.self;
    search_ = {};
    zones_ = {};
    report_ = {};
    crossings_at_start_ = coincident_at_start_ = 0;
    if (!on_) return;
    share(settings.solver.threads);
    use_hierarchy(settings, models);
    crossings_at_start_ = search_.count_crossings(x);
    coincident_at_start_ = search_.count_coincident(x);
}

void SelfContact::use_hierarchy(const Settings& settings, std::span<const ClothModel* const> models) {
    if (!on_) return;
    BroadPhaseParameters parameters = broad_phase_of(settings);
    parameters.search = {};
    if (parameters.leaf_cells == 0) parameters.leaf_cells = pair_leaf_cells;
    search_.use(parameters, models);
}

void SelfContact::find(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                       std::vector<ContactRow>& rows) {
    if (!on_) return;
    const Real thickness = parameters.pair_thickness;
    report_ = search_.find(cloths, thickness);
    for (const NearPair& pair : search_.pairs()) {
        if (!pair.is_representative) continue;
        ContactRow row = row_of(pair, thickness);
        update_depths(cloths, {}, {&row, 1});
        // A pair that stays well apart is left to the fail-safe
        if (-row.depth <= (search_.reach_of(pair) - thickness) / 4) rows.push_back(row);
    }
}

bool SelfContact::would_cross(std::span<const ClothInContact> cloths) {
    if (!on_) return false;
    search_.extend(cloths, report_);
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
    const Real least = std::max(of_thickness_kept * search_.thickness(), rounding);
    return is_near() && zones_.find(search_.pairs(), cloths, search_.first_particles(), least);
}

/// What is held back may move otherwise than the search has assumed.
std::int64_t SelfContact::prevent_crossing(std::span<const ClothInContact> cloths) {
    do zones_.prevent_crossing(search_.pairs(), cloths);
    while (search_.extend(cloths, report_));
    return zones_.particles();
}

}  // namespace drape
