#pragma once

#include <cmath>
#include <vector>

#include "drape/model/cloth_model.h"

namespace drape::bench {

/// The springs of a cloth as a list of pairs, as many programs keep them: what the forces cost when the grid is not
/// made use of.
class SpringList {
public:
    explicit SpringList(const ClothModel& model) {
        const Grid grid = model.grid;
        const auto add = [&](int i, int j, int di, int dj, const SpringLaw& law) {
            if (i + di < 0 || i + di >= grid.nx || j + dj >= grid.ny) return;
            springs_.push_back({grid.particle(i, j), grid.particle(i + di, j + dj), law.stiffness, law.damping,
                                std::hypot(static_cast<Real>(di) * model.hx, static_cast<Real>(dj) * model.hy)});
        };
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) {
                add(i, j, 1, 0, model.structural), add(i, j, 0, 1, model.structural);
                add(i, j, 1, 1, model.shear), add(i, j, -1, 1, model.shear);
                add(i, j, 2, 0, model.bend), add(i, j, 0, 2, model.bend);
            }
        }
    }

    /// Gravity, drag and springs; no wind.
    void forces(const ClothModel& model, const Points& x, const Points& v, Points& f) const {
        for (int axis = 0; axis < 3; ++axis) {
            f.col(axis).array() = model.particle_mass * model.gravity[axis] - model.drag * v.col(axis).array();
        }
        for (const Spring& s : springs_) {
            const Vec3 d = (x.row(s.a) - x.row(s.b)).transpose(), dv = (v.row(s.a) - v.row(s.b)).transpose();
            const Real length = d.norm();
            if (length == 0) continue;
            const Vec3 n = d / length;
            const Vec3 pull = (s.stiffness * (length - s.rest_length) + s.damping * n.dot(dv)) * n;
            f.row(s.a) -= pull.transpose();
            f.row(s.b) += pull.transpose();
        }
    }

private:
    struct Spring {
        int a, b;
        Real stiffness, damping, rest_length;
    };
    std::vector<Spring> springs_;
};

}  // namespace drape::bench
