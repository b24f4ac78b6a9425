#include "full_model.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/model/cloth_model.h"
#include "notches.h"

namespace drape {

// Small against any motion, large against rounding
const double small_error = sizeof(Real) == 8 ? 1e-9 : 1e-4;

namespace {

/// The start of a motion with an error in every particle that is free, as a file that settings can name; gone with the
/// object.
class DisturbedStart {
public:
    DisturbedStart(const Settings& scene, const Points& x)
        : path_(std::filesystem::temp_directory_path() / ("drape_start_" + std::to_string(getpid()) + ".csv")) {
        const ClothModel model = make_cloth_model(scene.cloths[0]);
        OutputFile file(path_.string());
        file.stream() << "t,particle,x,y,z,vx,vy,vz\n";
        for (int p = 0; p < model.grid.particles(); ++p) {
            file.stream() << "0," << p;
            for (int axis = 0; axis < 3; ++axis) {
                // In no direction that the cloth prefers: angles of which none is like another, of size one in the mean
                const double error =
                    model.pinned(p) ? 0 : small_error * std::sqrt(2.0 / 3) * std::sin(1 + 3 * p + axis);
                file.stream() << ',' << real_text(static_cast<double>(x(p, axis)) + error, 17);
            }
            file.stream() << ",0,0,0\n";
        }
        file.close();
    }
    ~DisturbedStart() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    DisturbedStart(const DisturbedStart&) = delete;
    DisturbedStart& operator=(const DisturbedStart&) = delete;

    [[nodiscard]] std::string file() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

}  // namespace

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

Settings computed_closely(Settings scene, Real dt) {
    scene.solver.integrator = IntegratorKind::DormandPrince;
    scene.solver.tolerance = Real(1e-6);
    scene.solver.dt = dt;
    return scene;
}

Motion disturbed_motion(const Settings& scene, const Points& start) {
    const DisturbedStart file(scene, start);
    Settings disturbed = scene;
    disturbed.start = file.file();
    return run_to_horizon(disturbed);
}

}  // namespace drape
