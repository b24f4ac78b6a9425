#include "drape/model/forces.h"

#include "drape/base/assert.h"
#include "drape/model/stencils.h"

namespace drape {

void compute_forces(const ClothModel& model, const Points& x, const Points& v, Points& f) {
    const Eigen::Index n = model.grid.particles();
    DRAPE_ASSERT(x.rows() == n && v.rows() == n && f.rows() == n);
    f = (model.particle_mass * model.gravity).transpose().replicate(n, 1) - model.drag * v;
    if (model.air.density > 0) add_wind_forces(model, x, v, f);
    for (const SpringStencil& springs : spring_stencils(model)) {
        springs.for_each(model.grid, [&](int a, int b) {
            const Vec3 d = x.row(a) - x.row(b), w = v.row(a) - v.row(b);
            const Vec3 force = spring_force(springs.law, springs.rest_length, d, w);
            f.row(a) += force.transpose();
            f.row(b) -= force.transpose();
        });
    }
}

Vec3 force_on(const ClothModel& model, const Points& x, const Points& v, int particle) {
    Vec3 force = model.particle_mass * model.gravity - model.drag * v.row(particle).transpose();
    for_each_spring_at(model, particle, [&](const SpringStencil& springs, int other) {
        const Vec3 d = x.row(particle) - x.row(other), w = v.row(particle) - v.row(other);
        force += spring_force(springs.law, springs.rest_length, d, w);
    });
    return force;
}

void add_wind_forces(const ClothModel& model, const Points& x, const Points& v, Points& f) {
    for (int triangle = 0; triangle < model.grid.triangles(); ++triangle) {
        const auto [a, b, c] = model.grid.triangle_corners(triangle);
        const Vec3 force = wind_force(model.air, {x.row(a), x.row(b), x.row(c)}, {v.row(a), v.row(b), v.row(c)});
        for (const int corner : {a, b, c}) f.row(corner) += force.transpose() / 3;
    }
}

}  // namespace drape
