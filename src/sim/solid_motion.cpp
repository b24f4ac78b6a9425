#include "solid_motion.h"

#include "ball_motion.h"
#include "drape/scene/mesh_file.h"

namespace drape {
namespace {

std::shared_ptr<const SolidShape> shape_of(const SolidSettings& settings) {
    switch (settings.shape) {
        case SolidKind::Box:
            return make_box(settings.size);
        case SolidKind::Capsule:
            return make_capsule(settings.radius, settings.length);
        case SolidKind::Mesh:
            return make_mesh_shape(read_mesh(settings.file));
    }
    return nullptr;
}

}  // namespace

std::vector<Solid> make_solids(const std::vector<SolidSettings>& settings) {
    std::vector<Solid> solids;
    for (const SolidSettings& one : settings) {
        Solid& solid = solids.emplace_back();
        solid.shape = shape_of(one);
        solid.orientation = turn_about(one.axis.normalized(), static_cast<double>(one.angle) / 360);
    }
    return solids;
}

void put_solids(const std::vector<SolidSettings>& settings, double time, std::vector<Solid>& solids) {
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const bool on_path = settings[s].motion == SolidMotion::Path;
        solids[s].position = on_path ? point_on_path(settings[s].path, static_cast<Real>(time)) : settings[s].position;
        solids[s].velocity.setZero();
        solids[s].moved.setZero();
    }
}

void move_solid(const SolidSettings& settings, Real time, Real h, Solid& solid) {
    if (settings.motion == SolidMotion::Still) return;
    solid.position = point_on_path(settings.path, time + h);
    solid.moved = solid.position - point_on_path(settings.path, time);
    solid.velocity = solid.moved / h;
}

}  // namespace drape
