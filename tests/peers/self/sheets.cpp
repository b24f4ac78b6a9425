#include "sheets.h"

#include "bench/refined.h"
#include "crossings/self_scenes.h"
#include "drape/sim/simulation.h"

namespace drape::peers {
namespace {

constexpr double start = 0.5, frame_time = 1.0 / 60;  // [s]
constexpr int finest_simulated = 64;

void lay_out(Sheets& sheets, const Settings& settings) {
    int particles = 0;
    for (const ClothParameters& cloth : settings.cloths) {
        const ClothModel model = make_cloth_model(cloth);
        sheets.grids.push_back(model.grid);
        sheets.spacings.push_back({model.hx, model.hy});
        sheets.first_triangles.push_back(sheets.triangles());
        for (int t = 0; t < model.grid.triangles(); ++t) {
            auto corners = model.grid.triangle_corners(t);
            for (int& corner : corners) corner += particles;
            sheets.corners.push_back(corners);
        }
        particles += model.grid.particles();
    }
}

SheetFrame frame_of(const Sheets& sheets, const Simulation& simulation) {
    SheetFrame frame;
    Eigen::Index particles = 0;
    for (std::size_t c = 0; c < sheets.grids.size(); ++c) {
        const Cloth& cloth = simulation.cloths()[c];
        frame.of_cloths.push_back(bench::refined(sheets.grids[c], cloth.model.grid, cloth.state.x));
        particles += frame.of_cloths[c].rows();
    }
    frame.x.resize(particles, 3);
    Eigen::Index row = 0;
    for (const Points& x : frame.of_cloths) {
        frame.x.middleRows(row, x.rows()) = x;
        row += x.rows();
    }
    return frame;
}

}  // namespace

Sheets::Sheets(const std::string& name, int side_of_grid, int count) : scene(name), side(side_of_grid) {
    const Settings as_raced = crossings::scene_of_side(scene, side);
    thickness = response_of(as_raced).pair_thickness;
    lay_out(*this, as_raced);
    // By XPBD, whose long steps get there sooner
    Settings settings = crossings::scene_of_side(scene, std::min(side, finest_simulated));
    settings.solver.sleep_speed = 0;
    crossings::use_method(settings, IntegratorKind::Xpbd);
    settings.solver.iterations = 3;
    Simulation simulation(scene, settings);
    for (int f = 0; f < count; ++f) {
        while (simulation.report().time < start + f * frame_time) simulation.step();
        frames.push_back(frame_of(*this, simulation));
        find_all_pairs(*this, frames.back());
    }
}

void make_boxes(const Sheets& sheets, const Points& x, std::vector<Aabb>& boxes) {
    boxes.clear();
    for (const auto& [a, b, c] : sheets.corners) {
        Aabb box{x.row(a).transpose(), x.row(a).transpose()};
        box.include(Vec3(x.row(b).transpose()));
        box.include(Vec3(x.row(c).transpose()));
        boxes.push_back(box);
    }
}

}  // namespace drape::peers
