#include "drape/sim/self_contact.h"

namespace drape {
namespace {

/// The side of a leaf where none is given: a pair of leaves is tested cell by cell.
constexpr int pair_leaf_cells = 4;

/// How far two features are beyond the thickness after the integrator's step, along the normal of its start.
Real gap_after(std::span<const ClothInContact> cloths, const NearPair& pair, Real thickness) {
    Vec3 offset = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
        const ClothInContact& cloth = cloths[static_cast<std::size_t>(pair.features.cloth_of(k))];
        offset += pair.signed_weight(k) * cloth.state.x.row(pair.features.particles[k]).transpose();
    }
    return offset.dot(pair.normal) - thickness;
}

}  // namespace

void SelfContact::use(const Settings& settings, std::span<const ClothModel* const> models) {
    on_ = settings.contact.self;
    contacts_.clear();
    warm_start_.forget();
    search_ = {};
    bounds_ = {};
    if (!on_) return;
    BroadPhaseParameters parameters = broad_phase_of(settings);
    parameters.search = {};
    if (parameters.leaf_cells == 0) parameters.leaf_cells = pair_leaf_cells;
    search_.use(parameters, models);
    particles_.clear();
    for (const ClothModel* model : models) particles_.push_back(model->grid.particles());
}

void SelfContact::take_pushes(const ResponseParameters& parameters, Real h, Real gravity,
                              std::span<const ClothInContact> cloths) {
    if (on_) warm_start_.take(parameters, h, gravity, cloths, contacts_);
}

SelfSearchReport SelfContact::find(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                                   std::span<const Ball> balls) {
    if (!on_) return {};
    const Real thickness = parameters.pair_thickness;
    const SelfSearchReport report = search_.find(cloths, thickness);
    bounds_.start(particles_, search_.reaches());
    contacts_.clear();
    for (const NearPair& pair : search_.pairs()) {
        bounds_.tighten(pair);
        // A pair that stays well apart is left to the fail-safe
        const Real ahead = (search_.reach_of(pair.features) - thickness) / 4;
        if (!pair.stands_alone || gap_after(cloths, pair, thickness) > ahead) continue;
        PairContact contact;
        contact.pair = pair;
        contact.normal = pair.normal;
        contacts_.push_back(contact);
    }
    warm_start_.carry_over(parameters, cloths, balls, contacts_);
    return report;
}

BoundedMotion SelfContact::hold_back(std::span<const ClothInContact> cloths) const {
    BoundedMotion all;
    if (!on_) return all;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const ClothInContact& cloth = cloths[c];
        all += bounds_.hold_back(static_cast<int>(c), cloth.model, cloth.before, cloth.state);
    }
    return all;
}

}  // namespace drape
