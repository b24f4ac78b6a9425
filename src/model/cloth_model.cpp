#include "drape/model/cloth_model.h"

#include <algorithm>
#include <utility>

#include "drape/base/assert.h"

namespace drape {

bool is_pinned(const Pins& pins, const Grid& grid, int particle) {
    const int i = particle % grid.nx, j = particle / grid.nx;
    const bool left = i == 0, right = i == grid.nx - 1, first = j == 0, last = j == grid.ny - 1;
    switch (pins.kind) {
        case Pins::Kind::Two:
            return first && (left || right);
        case Pins::Kind::Four:
            return (first || last) && (left || right);
        case Pins::Kind::Row:
            return first;
        case Pins::Kind::Border:
            return first || last || left || right;
        case Pins::Kind::None:
        case Pins::Kind::List:
            return false;
    }
    return false;
}

ClothModel make_cloth_model(const ClothParameters& parameters) {
    const Grid grid = parameters.particles;
    DRAPE_ASSERT(grid.nx >= 2 && grid.ny >= 2);
    DRAPE_ASSERT(parameters.width > 0 && parameters.height > 0 && parameters.mass > 0 && parameters.drag >= 0);
    DRAPE_ASSERT(parameters.stretch_limit >= 0);
    ClothModel model;
    model.grid = grid;
    model.hx = parameters.hx();
    model.hy = parameters.hy();
    model.particle_mass = parameters.mass / static_cast<Real>(grid.particles());
    model.structural = parameters.structural;
    model.shear = parameters.shear;
    model.bend = parameters.bend;
    model.drag = parameters.drag;
    model.stretch_limit = parameters.stretch_limit;
    model.inverse_mass.setConstant(grid.particles(), 1 / model.particle_mass);
    for (int p = 0; p < grid.particles(); ++p) {
        if (is_pinned(parameters.pinned, grid, p)) model.inverse_mass[p] = 0;
    }
    for (const int particle : parameters.pinned.list) {
        DRAPE_ASSERT(particle >= 0 && particle < grid.particles());
        model.inverse_mass[particle] = 0;
    }
    return model;
}

void ClothModel::hold(int particle, bool held) {
    DRAPE_ASSERT(particle >= 0 && particle < grid.particles());
    inverse_mass[particle] = held ? Real(0) : 1 / particle_mass;
    ++revision;
}

ClothState make_rest_state(const ClothParameters& parameters) {
    const Grid grid = parameters.particles;
    ClothState state;
    state.x.resize(grid.particles(), 3);
    state.v.setZero(grid.particles(), 3);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const Real across = static_cast<Real>(i) * parameters.hx(), along = static_cast<Real>(j) * parameters.hy();
            const Vec3 offset = parameters.plane == Plane::XZ ? Vec3(across, 0, along) : Vec3(across, -along, 0);
            state.x.row(grid.particle(i, j)) = (parameters.origin() + offset).transpose();
        }
    }
    return state;
}

Points resampled(const Points& x, const Grid& from, const Grid& to) {
    if (from == to) return x;
    Points finer(to.particles(), 3);
    const auto cell_of = [](int k, int count, int cells) {
        const Real along = static_cast<Real>(k) * static_cast<Real>(cells) / static_cast<Real>(count - 1);
        const int cell = std::min(static_cast<int>(along), cells - 1);
        return std::pair(cell, along - static_cast<Real>(cell));
    };
    for (int j = 0; j < to.ny; ++j) {
        const auto [row, v] = cell_of(j, to.ny, from.cell_rows());
        for (int i = 0; i < to.nx; ++i) {
            const auto [column, u] = cell_of(i, to.nx, from.cell_columns());
            const int a = from.particle(column, row), c = from.particle(column, row + 1);
            finer.row(to.particle(i, j)) =
                (1 - v) * ((1 - u) * x.row(a) + u * x.row(a + 1)) + v * ((1 - u) * x.row(c) + u * x.row(c + 1));
        }
    }
    return finer;
}

}  // namespace drape
