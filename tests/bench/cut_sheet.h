#pragma once

#include <cmath>
#include <numbers>

#include "drape/model/ball.h"
#include "drape/model/grid.h"

namespace drape::bench {

/// A square sheet of side 1 in waves, and a ball in its middle that cuts a tenth of it out.
struct CutSheet {
    Grid grid;
    Points x;
    Ball ball;

    explicit CutSheet(int side) : grid{side, side}, x(grid.particles(), 3) {
        ball.radius = std::sqrt(Real(0.1) / std::numbers::pi_v<Real>);
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const Real u = static_cast<Real>(i) / static_cast<Real>(side - 1) - Real(0.5);
                const Real w = static_cast<Real>(j) / static_cast<Real>(side - 1) - Real(0.5);
                x.row(grid.particle(i, j)) << u, Real(0.05) * std::sin(9 * u) * std::cos(7 * w), w;
            }
        }
    }
};

}  // namespace drape::bench
