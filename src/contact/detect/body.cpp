#include "drape/contact/body.h"

namespace drape {

SurfaceDistance Body::measure(const Vec3& p) const {
    if (solid != nullptr) return solid->measure(p);
    if (is_ground()) return {p.y() - centre.y(), Vec3(0, 1, 0)};
    const Vec3 offset = p - centre;
    const Real distance = offset.norm();
    return {distance - radius, distance > 0 ? Vec3(offset / distance) : Vec3(0, 1, 0)};
}

Body body_of(const Ball& ball, const Surface& surface) { return {ball, nullptr, surface}; }

Body body_of(const Solid& solid, const Surface& surface) {
    return {{.centre = solid.position, .radius = 0, .velocity = solid.velocity, .moved = solid.moved}, &solid, surface};
}

Body body_of(const Ground& ground) {
    return {{.centre = Vec3(0, ground.height, 0), .radius = 0},
            nullptr,
            {ground.friction, ground.restitution, ground.rolling}};
}

}  // namespace drape
