#include "reference.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "drape/base/assert.h"
#include "precision_run.h"

namespace drape {
namespace {

/// A rung of the ladder.
struct Rung {
    IntegratorParameters method;
    std::vector<Real> steps;
};

/// The state of rest with a small error in every free coordinate: symmetry would hide what grows.
ClothState nudged_start(const ClothParameters& cloth) {
    const ClothModel model = make_cloth_model(cloth);
    ClothState state = make_rest_state(cloth);
    std::mt19937 random(1);
    std::uniform_real_distribution<Real> draw(-1, 1);
    Points error = Points::Zero(state.x.rows(), 3);
    int free = 0;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) continue;
        ++free;
        for (int axis = 0; axis < 3; ++axis) error(p, axis) = draw(random);
    }
    state.x += error * (start_error * std::sqrt(static_cast<Real>(free)) / error.norm());
    return state;
}

/// Growth is found on a rung of its own, which may be less fine.
Reference climb(const PrecisionScene& scene, const Rung& coarse, const Rung& before, const Rung& last) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const auto reach = [&scene](const Rung& rung, const std::optional<ClothState>& start = {}) {
        return finish(scene, rung.method, rung.steps, start).state;
    };
    const ClothState nudged = nudged_start(cloth), start = make_rest_state(cloth);
    const double small = static_cast<double>((nudged.x - start.x).norm());
    Reference reference;
    reference.growth = static_cast<double>((reach(coarse, nudged).x - reach(coarse).x).norm()) / small;
    reference.measure = measure_for(reference.growth);
    reference.state = reach(last);
    reference.error =
        error_of(reference.measure, make_cloth_model(cloth), reach(before), reference.state, scene.side());
    return reference;
}

}  // namespace

Reference find_reference(const PrecisionScene& scene, std::span<const Real> tolerances) {
    DRAPE_ASSERT(tolerances.size() >= 2 && !scene.has_ball());
    const auto rung = [&scene](Real tolerance) {
        return Rung{{.kind = IntegratorKind::DormandPrince, .tolerance = tolerance},
                    steps_to(scene.horizon, outer_steps)};
    };
    const Rung before = rung(tolerances[tolerances.size() - 2]);
    return climb(scene, before, before, rung(tolerances.back()));
}

Reference find_reference(const PrecisionScene& scene) {
    if (!scene.has_ball()) return find_reference(scene, std::array{Real(1e-11), Real(1e-12)});
    const auto rung = [&scene](int parts) {
        return Rung{{.kind = IntegratorKind::VelocityVerlet}, steps_to(scene.horizon, scene.reference_steps / parts)};
    };
    return climb(scene, rung(16), rung(2), rung(1));
}

}  // namespace drape
