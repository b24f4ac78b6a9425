#include "full_model.h"

#include <algorithm>

#include "drape/base/input_error.h"

#include "notches.h"

namespace drape {

Settings full_model(const Settings& scene) {
    if (scene.cloths.size() != 1) throw InputError("needs: allowed only scenes with one cloth");
    const FullModelSettings& full = scene.needs.full;
    Settings model = scene;
    if (full.particles != Grid{0, 0}) {
        if (std::min(full.particles.nx, full.particles.ny) < 2) {
            throw InputError("needs.full.particles: allowed at least 2 columns and 2 rows");
        }
        model = on_grid(model, full.particles);
    }
    if (full.bend != SpringLaw{}) model.cloths[0].bend = full.bend;
    if (full.drag > 0) model.cloths[0].drag = full.drag;
    return model;
}

Settings computed_closely(Settings scene, double dt) {
    scene.solver.integrator = IntegratorKind::DormandPrince;
    scene.solver.tolerance = Real(1e-6);
    scene.solver.dt = dt;
    scene.contact.search_level = SearchLimit::all_levels;
    scene.contact.search_tests = 0;
    return scene;
}

}  // namespace drape
