#include "reference.h"

#include <array>
#include <vector>

#include "drape/base/assert.h"
#include "precision_run.h"

namespace drape {
namespace {

/// A rung of the ladder.
struct ReferenceRung {
    IntegratorParameters method;
    std::vector<Real> steps;
};

/// Growth is found on a rung of its own, which may be less fine.
Reference climb(const PrecisionScene& scene, const ReferenceRung& coarse, const ReferenceRung& before,
                const ReferenceRung& last) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const auto reach = [&scene](const ReferenceRung& rung, const std::optional<ClothState>& start = {}) {
        return finish(scene, rung.method, rung.steps, start).state;
    };
    const ClothModel model = make_cloth_model(cloth);
    const ClothState start = make_rest_state(cloth), nudged = disturbed(model, start);
    const double small = static_cast<double>((nudged.x - start.x).norm());
    Reference reference;
    reference.growth = static_cast<double>((reach(coarse, nudged).x - reach(coarse).x).norm()) / small;
    reference.measure = measure_for(reference.growth);
    reference.state = reach(last);
    reference.error = error_of(reference.measure, model, reach(before), reference.state, scene.side());
    return reference;
}

}  // namespace

Reference find_reference(const PrecisionScene& scene, std::span<const Real> tolerances) {
    DRAPE_ASSERT(tolerances.size() >= 2 && !scene.has_ball());
    const auto rung = [&scene](Real tolerance) {
        return ReferenceRung{{.kind = IntegratorKind::DormandPrince, .tolerance = tolerance},
                             steps_to(scene.horizon, outer_steps)};
    };
    const ReferenceRung before = rung(tolerances[tolerances.size() - 2]);
    return climb(scene, before, before, rung(tolerances.back()));
}

Reference find_reference(const PrecisionScene& scene) {
    if (!scene.has_ball()) return find_reference(scene, std::array{Real(1e-11), Real(1e-12)});
    const auto rung = [&scene](int parts) {
        return ReferenceRung{{.kind = IntegratorKind::VelocityVerlet},
                             steps_to(scene.horizon, scene.reference_steps / parts)};
    };
    return climb(scene, rung(16), rung(2), rung(1));
}

}  // namespace drape
