#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "drape/base/exact_math.h"
#include "drape/contact/solid_shape.h"

namespace drape {
namespace {

Vec3 unit(int axis, Real sign) {
    Vec3 direction = Vec3::Zero();
    direction[axis] = sign;
    return direction;
}

/// All points within a radius of a core, which is a box: with the radius 0 that box, about a segment a capsule.
class RoundedBox final : public SolidShape {
public:
    /// @param half of the core, along its three axes [m]
    RoundedBox(const Vec3& half, Real radius, std::vector<Segment> ridges, TriangleMesh surface)
        : half_(half), radius_(radius), ridges_(std::move(ridges)), surface_(std::move(surface)) {}

    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const override {
        const Vec3 offset = p - p.cwiseMax(-half_).cwiseMin(half_);
        const Real outside = offset.norm();
        if (outside > 0) return {outside - radius_, offset / outside};
        Eigen::Index axis = 0;
        const Real inside = (p.cwiseAbs() - half_).maxCoeff(&axis);
        return {inside - radius_, unit(static_cast<int>(axis), p[axis] < 0 ? Real(-1) : Real(1))};
    }

    [[nodiscard]] bool is_convex() const override { return true; }
    [[nodiscard]] std::span<const Segment> ridges() const override { return ridges_; }
    [[nodiscard]] std::array<Vec3, 2> extent() const override {
        const Vec3 corner = half_ + Vec3::Constant(radius_);
        return {-corner, corner};
    }
    [[nodiscard]] TriangleMesh surface() const override { return surface_; }

private:
    Vec3 half_;
    Real radius_;
    std::vector<Segment> ridges_;
    TriangleMesh surface_;
};

/// The signs of the corners of a side of a box, one after the other.
constexpr std::array<std::array<int, 2>, 4> side_corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

/// The sides of a box: four along each axis, at the ends of both others.
std::vector<Segment> box_sides(const Vec3& half) {
    std::vector<Segment> sides;
    for (int axis = 0; axis < 3; ++axis) {
        for (const auto& [along_u, along_v] : side_corners) {
            Vec3 end = half;
            end[(axis + 1) % 3] *= static_cast<Real>(along_u);
            end[(axis + 2) % 3] *= static_cast<Real>(along_v);
            Vec3 start = end;
            start[axis] = -start[axis];
            sides.push_back({start, end});
        }
    }
    return sides;
}

/// Each face has four points of its own: its normal is not theirs on the other faces.
TriangleMesh box_surface(const Vec3& half) {
    TriangleMesh mesh;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2, first = 4 * face;
        const Real sign = face % 2 == 0 ? Real(-1) : Real(1);
        for (const auto& [along_u, along_v] : side_corners) {
            Vec3 corner = unit(axis, sign);
            corner[(axis + 1) % 3] = static_cast<Real>(along_u) * sign;
            corner[(axis + 2) % 3] = static_cast<Real>(along_v);
            mesh.points.push_back(corner.cwiseProduct(half));
            mesh.normals.push_back(unit(axis, sign));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

/// A sphere whose halves are drawn apart, ring by ring from the top.
/// @param half of the segment, along the y axis [m]
TriangleMesh capsule_surface(Real half, Real radius) {
    constexpr int columns = 48, rings = 26;
    constexpr double pi = std::numbers::pi;
    TriangleMesh mesh;
    for (int ring = 0; ring < rings; ++ring) {
        const bool upper = ring < rings / 2;
        const double polar = pi * (upper ? ring : ring - 1) / (rings - 2);
        const double across = sine(polar), up = sine(polar + pi / 2);
        for (int k = 0; k < columns; ++k) {
            const double turn = 2 * pi * k / columns;
            const Vec3 normal(static_cast<Real>(across * sine(turn)), static_cast<Real>(up),
                              static_cast<Real>(across * sine(turn + pi / 2)));
            mesh.normals.push_back(normal);
            mesh.points.push_back(radius * normal + Vec3(0, upper ? half : -half, 0));
            const int a = ring * columns + k, b = ring * columns + (k + 1) % columns;
            if (ring > 0 && ring + 1 < rings) mesh.triangles.push_back({a, a + columns, b});
            if (ring + 2 < rings) mesh.triangles.push_back({b, a + columns, b + columns});
        }
    }
    return mesh;
}

}  // namespace

std::shared_ptr<const SolidShape> make_box(const Vec3& size) {
    const Vec3 half = size / 2;
    return std::make_shared<RoundedBox>(half, Real(0), box_sides(half), box_surface(half));
}

std::shared_ptr<const SolidShape> make_capsule(Real radius, Real length) {
    const Vec3 half(0, length / 2, 0);
    const Segment axis{-half, half};
    return std::make_shared<RoundedBox>(half, radius, std::vector{axis}, capsule_surface(half.y(), radius));
}

}  // namespace drape
