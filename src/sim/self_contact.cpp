#include "drape/sim/self_contact.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// The side of a leaf where none is given: a pair of leaves is tested cell by cell.
constexpr int pair_leaf_cells = 4;

/// Of the thickness, that cloth keeps from cloth whatever presses it.
constexpr Real of_thickness_kept = Real(1e-3);

/// How far two features are beyond the thickness after the integrator's step, along the normal of its start.
Real gap_after(std::span<const ClothInContact> cloths, const NearPair& pair, Real thickness) {
    Vec3 offset = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
        const ClothInContact& cloth = cloths[static_cast<std::size_t>(pair.features.cloth_of(k))];
        offset += pair.signed_weight(k) * cloth.state.x.row(pair.features.particles[k]).transpose();
    }
    return offset.dot(pair.normal) - thickness;
}

/// Whatever answers balls, pairs are projected.
ResponseParameters of_pairs(ResponseParameters parameters) {
    parameters.kind = ResponseKind::Projection;
    return parameters;
}

}  // namespace

void SelfContact::use(const Settings& settings, std::span<const ClothModel* const> models,
                      std::span<const Points* const> x) {
    on_ = settings.contact.self;
    contacts_.clear();
    warm_start_.forget();
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

void SelfContact::take_pushes(const ResponseParameters& parameters, Real h, Real gravity,
                              std::span<const ClothInContact> cloths) {
    if (on_) warm_start_.take(of_pairs(parameters), h, gravity, cloths, contacts_);
}

void SelfContact::find(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                       std::span<const Ball> balls) {
    if (!on_) return;
    const Real thickness = parameters.pair_thickness;
    report_ = search_.find(cloths, thickness);
    contacts_.clear();
    for (const NearPair& pair : search_.pairs()) {
        // A pair that stays well apart is left to the fail-safe
        const Real ahead = (search_.reach_of(pair) - thickness) / 4;
        if (!pair.is_representative || gap_after(cloths, pair, thickness) > ahead) continue;
        PairContact contact;
        contact.pair = pair;
        contact.normal = pair.normal;
        contacts_.push_back(contact);
    }
    warm_start_.carry_over(of_pairs(parameters), cloths, balls, contacts_);
}

bool SelfContact::would_cross(std::span<const ClothInContact> cloths) {
    if (!on_) return false;
    search_.extend(cloths, report_);
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
    const Real least = std::max(of_thickness_kept * search_.thickness(), rounding);
    return is_near() && zones_.find(search_.pairs(), cloths, search_.first_particles(), least);
}

/// What is held back may go another way than the search has assumed.
std::int64_t SelfContact::prevent_crossing(std::span<const ClothInContact> cloths) {
    do zones_.prevent_crossing(search_.pairs(), cloths);
    while (search_.extend(cloths, report_));
    return zones_.particles();
}

}  // namespace drape
