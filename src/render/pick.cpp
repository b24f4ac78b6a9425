#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drape/render/camera.h"
#include "frame_data.h"

namespace drape {

namespace {

constexpr Real nothing = std::numeric_limits<Real>::infinity();

struct Hit {
    Real distance = nothing;
    std::array<Real, 3> barycentric{};
};

// A ray against both sides of a triangle  @cite moller1997
Hit hit_triangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, p = ray.direction.cross(ac);
    const Real determinant = ab.dot(p);
    if (std::abs(determinant) < std::numeric_limits<Real>::min()) return {};
    const Vec3 s = ray.origin - a, q = s.cross(ab);
    const Real v = s.dot(p) / determinant, w = ray.direction.dot(q) / determinant, t = ac.dot(q) / determinant;
    if (!(v >= 0 && w >= 0 && v + w <= 1 && t > 0)) return {};
    return {t, {1 - v - w, v, w}};
}

Real hit_ball(const Ray& ray, const Vec3& centre, Real radius) {
    const Vec3 to_centre = centre - ray.origin;
    const Real middle = to_centre.dot(ray.direction);
    const Real inside = radius * radius - (to_centre - middle * ray.direction).squaredNorm();
    if (inside < 0 || middle - std::sqrt(inside) <= 0) return nothing;
    return middle - std::sqrt(inside);
}

// By steps of the distance, which meet nothing on their way
Real hit_solid(const Ray& ray, const Solid& solid) {
    constexpr Real near = Real(1e-4), far = 1000;
    constexpr int most_steps = 256;
    Real along = 0;
    for (int step = 0; step < most_steps && along < far; ++step) {
        const Real distance = solid.distance(ray.origin + along * ray.direction);
        if (distance < near) return along;
        along += distance;
    }
    return nothing;
}

}  // namespace

Pick pick_particle(const FrameView& view, const Ray& ray) {
    Pick pick;
    Real nearest = nothing;
    for (std::size_t i = 0; i < view.balls.size(); ++i) {
        const Eigen::Vector4f ball = drawn_ball(view, i);
        nearest = std::min(nearest, hit_ball(ray, ball.head<3>().cast<Real>(), static_cast<Real>(ball.w())));
    }
    for (std::size_t i = 0; i < view.solids.size(); ++i) {
        Solid solid = view.solids[i];
        solid.position = drawn_solid(view, i).cast<Real>();
        nearest = std::min(nearest, hit_solid(ray, solid));
    }
    for (std::size_t number = 0; number < view.cloths.size(); ++number) {
        const ClothView& cloth = view.cloths[number];
        const Grid& grid = cloth.model.grid;
        for (int triangle = 0; triangle < grid.triangles(); ++triangle) {
            const std::array<int, 3> corners = grid.triangle_corners(triangle);
            const Hit hit = hit_triangle(ray, drawn_particle(cloth, view.blend, corners[0]),
                                         drawn_particle(cloth, view.blend, corners[1]),
                                         drawn_particle(cloth, view.blend, corners[2]));
            if (!(hit.distance < nearest)) continue;
            nearest = hit.distance;
            const auto largest = std::max_element(hit.barycentric.begin(), hit.barycentric.end());
            pick.cloth = static_cast<int>(number);
            pick.particle = corners[static_cast<std::size_t>(largest - hit.barycentric.begin())];
            pick.point = ray.origin + hit.distance * ray.direction;
        }
    }
    return pick;
}

}  // namespace drape
