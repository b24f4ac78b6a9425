#include "motion.h"

#include "drape/bounds/broad_phase.h"
#include "drape/contact/detection.h"

namespace drape::peers {

Motion::Motion(int side, int count) {
    const bench::CutSheet sheet(side);
    grid = sheet.grid;
    std::vector<CellRun> all;
    list_all_cells(grid, all);
    frames.reserve(static_cast<std::size_t>(count));
    for (int f = 0; f < count; ++f) {
        const Real phase = 2 * std::numbers::pi_v<Real> * static_cast<Real>(f) / static_cast<Real>(count);
        Frame frame{sheet.x, sheet.ball, {}};
        for (int p = 0; p < grid.particles(); ++p) {
            const Real u = sheet.x(p, 0), w = sheet.x(p, 2);
            frame.x(p, 0) += Real(0.005) * std::cos(9 * u - phase);
            frame.x(p, 1) = Real(0.05) * std::sin(9 * u - phase) * std::cos(7 * w);
            frame.x(p, 2) += Real(0.005) * std::sin(7 * w + phase);
        }
        frame.ball.centre +=
            Vec3(Real(0.15) * std::cos(phase), Real(0.03) * std::sin(2 * phase), Real(0.15) * std::sin(phase));
        find_touched_triangles(grid, frame.x, frame.ball, 0, all, frame.touched, Kernels::Vector);
        frames.push_back(std::move(frame));
    }
}

}  // namespace drape::peers
