#include "drape/contact/body.h"

namespace drape {

SurfaceDistance Body::measure(const Vec3& p) const {
    if (solid != nullptr) return solid->measure(p);
    if (is_ground()) return {p.y() - centre.y(), Vec3(0, 1, 0)};
    const Vec3 offset = p - centre;
    const Real distance = offset.norm();
    return {distance - radius, distance > 0 ? Vec3(offset / distance) : Vec3(0, 1, 0)};
}

Body body_of(const Ball& ball, const Surface& surface) {
    return {.radius = ball.radius,
            .centre = ball.centre,
            .moved = ball.moved,
            .turned = ball.turned,
            .velocity = ball.velocity,
            .spin = ball.spin,
            .inverse_mass = ball.inverse_mass,
            .inverse_inertia = ball.inverse_inertia(),
            .surface = surface};
}

Body body_of(const Solid& solid, const Surface& surface) {
    return {.solid = &solid,
            .centre = solid.position,
            .moved = solid.moved,
            .velocity = solid.velocity,
            .surface = surface};
}

Body body_of(const Ground& ground) {
    return {.centre = Vec3(0, ground.height, 0), .surface = {ground.friction, ground.restitution, ground.rolling}};
}

void store(const Body& body, Ball& ball) {
    if (body.inverse_mass == 0) return;
    ball.centre = body.centre;
    ball.moved = body.moved;
    ball.turned = body.turned;
    ball.velocity = body.velocity;
    ball.spin = body.spin;
}

}  // namespace drape
