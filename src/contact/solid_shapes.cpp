#include <algorithm>
#include <numbers>

#include "drape/base/exact_math.h"
#include "drape/contact/solid_shape.h"

namespace drape {
namespace {

Vec3 unit(int axis, Real sign) {
    Vec3 direction = Vec3::Zero();
    direction[axis] = sign;
    return direction;
}

class BoxShape final : public SolidShape {
public:
    explicit BoxShape(const Vec3& size) : half_(size / 2) {
        std::size_t next = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) sides_[next++] = side(axis, u, v);
        }
    }

    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const override {
        const Vec3 out = p.cwiseAbs() - half_;
        Eigen::Index axis = 0;
        const Real inside = out.maxCoeff(&axis);
        if (inside <= 0) return {inside, unit(static_cast<int>(axis), p[axis] < 0 ? Real(-1) : Real(1))};
        const Vec3 offset = p - p.cwiseMax(-half_).cwiseMin(half_);
        const Real distance = offset.norm();
        return {distance, offset / distance};
    }

    [[nodiscard]] bool is_convex() const override { return true; }
    [[nodiscard]] std::span<const Segment> ridges() const override { return sides_; }
    [[nodiscard]] std::array<Vec3, 2> extent() const override { return {-half_, half_}; }

    [[nodiscard]] TriangleMesh surface() const override {
        TriangleMesh mesh;
        for (int axis = 0; axis < 3; ++axis) {
            for (const Real sign : {Real(-1), Real(1)}) add_face(axis, sign, mesh);
        }
        return mesh;
    }

private:
    /// Four points of its own: its normal is not theirs on the other faces.
    void add_face(int axis, Real sign, TriangleMesh& mesh) const {
        const int first = static_cast<int>(mesh.points.size());
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const auto& [along_u, along_v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            Vec3 corner = unit(axis, sign);
            corner[u] = static_cast<Real>(along_u) * sign;
            corner[v] = static_cast<Real>(along_v);
            mesh.points.push_back(corner.cwiseProduct(half_));
            mesh.normals.push_back(unit(axis, sign));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }

    /// Along an axis, at an end of both others.
    [[nodiscard]] Segment side(int axis, int along_u, int along_v) const {
        Vec3 end = half_;
        end[(axis + 1) % 3] *= static_cast<Real>(along_u);
        end[(axis + 2) % 3] *= static_cast<Real>(along_v);
        Vec3 start = end;
        start[axis] = -start[axis];
        return {start, end};
    }

    Vec3 half_;
    std::array<Segment, 12> sides_;
};

class CapsuleShape final : public SolidShape {
public:
    CapsuleShape(Real radius, Real length)
        : radius_(radius), half_(length / 2), axis_{Segment{Vec3(0, -half_, 0), Vec3(0, half_, 0)}} {}

    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const override {
        const Vec3 offset = p - Vec3(0, std::clamp(p.y(), -half_, half_), 0);
        const Real distance = offset.norm();
        return {distance - radius_, distance > 0 ? Vec3(offset / distance) : Vec3(1, 0, 0)};
    }

    [[nodiscard]] bool is_convex() const override { return true; }
    [[nodiscard]] std::span<const Segment> ridges() const override { return axis_; }
    [[nodiscard]] std::array<Vec3, 2> extent() const override {
        const Vec3 corner(radius_, half_ + radius_, radius_);
        return {-corner, corner};
    }

    /// A sphere whose halves are drawn apart, ring by ring from the top.
    [[nodiscard]] TriangleMesh surface() const override {
        TriangleMesh mesh;
        for (int ring = 0; ring < rings; ++ring) add_ring(ring, mesh);
        for (int ring = 0; ring + 1 < rings; ++ring) {
            for (int k = 0; k < columns; ++k) {
                const int a = ring * columns + k, b = ring * columns + (k + 1) % columns;
                if (ring > 0) mesh.triangles.push_back({a, a + columns, b});
                if (ring + 2 < rings) mesh.triangles.push_back({b, a + columns, b + columns});
            }
        }
        return mesh;
    }

private:
    static constexpr int columns = 48, rings = 26;
    static constexpr double pi = std::numbers::pi;

    void add_ring(int ring, TriangleMesh& mesh) const {
        const bool upper = ring < rings / 2;
        const double polar = pi * (upper ? ring : ring - 1) / (rings - 2);
        const double across = sine(polar), up = sine(polar + pi / 2);
        for (int k = 0; k < columns; ++k) {
            const double turn = 2 * pi * k / columns;
            const Vec3 normal(static_cast<Real>(across * sine(turn)), static_cast<Real>(up),
                              static_cast<Real>(across * sine(turn + pi / 2)));
            mesh.normals.push_back(normal);
            mesh.points.push_back(radius_ * normal + Vec3(0, upper ? half_ : -half_, 0));
        }
    }

    Real radius_, half_;
    std::array<Segment, 1> axis_;
};

}  // namespace

std::shared_ptr<const SolidShape> make_box(const Vec3& size) { return std::make_shared<BoxShape>(size); }

std::shared_ptr<const SolidShape> make_capsule(Real radius, Real length) {
    return std::make_shared<CapsuleShape>(radius, length);
}

}  // namespace drape
