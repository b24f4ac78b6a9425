#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "drape/base/assert.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/solid_shape.h"
#include "grid_features.h"
#include "pairs/pair_tests.h"

namespace drape {
namespace {

using MeshBox = Eigen::AlignedBox<Real, 3>;

/// The angle between two directions of length 1, of + - * / and roots alone: theta / 2 = atan(|u - v| / |u + v|), by
/// the series of a sixteenth of the angle.
Real angle_between(const Vec3& u, const Vec3& v) {
    Real t = (u - v).norm() / (u + v).norm();
    for (int halving = 0; halving < 4; ++halving) t /= 1 + std::sqrt(1 + t * t);
    Real sum = 0;
    for (int k = 13; k > 0; k -= 2) sum = 1 / static_cast<Real>(k) - t * t * sum;
    return 32 * t * sum;
}

/// Of a point's distance from a box, without branches, which a processor would often guess wrongly.
Real square_to(const MeshBox& box, const Vec3& p) {
    const Vec3 out = (box.min() - p).cwiseMax(p - box.max()).cwiseMax(Vec3::Zero());
    return out.x() * out.x() + out.y() * out.y() + out.z() * out.z();
}

/// Between two boxes.
Real square_between(const MeshBox& box, const MeshBox& other) {
    return (box.min() - other.max()).cwiseMax(other.min() - box.max()).cwiseMax(Vec3::Zero()).squaredNorm();
}

/// Whether all of a triangle is on one side of another's plane, clearly farther from it than a distance. Of a triangle
/// that has none but for rounding, nothing is said.
bool is_beyond(const std::array<Vec3, 3>& triangle, const std::array<Vec3, 3>& other, Real square) {
    const Vec3 u = other[1] - other[0], v = other[2] - other[0], normal = u.cross(v);
    constexpr Real thin = 64 * std::numeric_limits<Real>::epsilon(), margin = Real(0.999);
    if (!(normal.squaredNorm() > thin * u.squaredNorm() * v.squaredNorm())) return false;
    const Real a = normal.dot(triangle[0] - other[0]), b = normal.dot(triangle[1] - other[0]),
               c = normal.dot(triangle[2] - other[0]);
    const Real least = std::max(std::min({a, b, c}), -std::max({a, b, c}));
    return least > 0 && margin * least * least > square * normal.squaredNorm();
}

/// The least distance of two triangles that is below `square`, or that: of a corner of the second, or of two sides.
/// Corners of the first are left to others. Less than zero where a side of one goes through the other.
Real square_between(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second, Real square) {
    if (is_beyond(first, second, square) || is_beyond(second, first, square)) return square;
    const auto square_to_triangle = [](const Vec3& p, const std::array<Vec3, 3>& triangle) {
        return (closest_point_on_triangle(p, triangle[0], triangle[1], triangle[2]).point - p).squaredNorm();
    };
    const auto pierces = [&](const std::array<Vec3, 3>& sides, const std::array<Vec3, 3>& triangle) {
        const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &p = sides[k], side = sides[(k + 1) % 3] - p;
            const Real height = normal.dot(p - triangle[0]), rise = normal.dot(side);
            if (height * (height + rise) >= 0) continue;
            constexpr Real rounding = 1024 * std::numeric_limits<Real>::epsilon();
            const Real off = square_to_triangle(p - height / rise * side, triangle);
            if (off <= rounding * side.squaredNorm()) return true;
            // As near as that where the plane is hardly one
            square = std::min(square, off);
        }
        return false;
    };
    if (pierces(first, second) || pierces(second, first)) return -1;
    for (const Vec3& corner : second) square = std::min(square, square_to_triangle(corner, first));
    Real distance = with_rounding(std::sqrt(square));
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
            const Vec3 &a = first[k], &b = first[(k + 1) % 3], &c = second[l], &d = second[(l + 1) % 3];
            if (segments_are_apart(a, b, c, d, distance)) continue;
            const Real off = closest_of_segments(a, b, c, d).offset.squaredNorm();
            if (off < square) square = off, distance = with_rounding(std::sqrt(square));
        }
    }
    return square;
}

/// Some of the triangles in the order of the tree, and the number of their box. Those of their halves follow: a range
/// of n triangles has 2 n - 1 boxes.
struct MeshRange {
    std::size_t box, first, count;

    [[nodiscard]] std::array<MeshRange, 2> halves() const {
        const std::size_t half = count / 2;
        return {MeshRange{box + 1, first, half}, MeshRange{box + 2 * half, first + half, count - half}};
    }
};

/// The closest of the triangles seen so far.
struct ClosestFeature {
    Real square = std::numeric_limits<Real>::infinity();  ///< of the distance
    int triangle = -1;
    ClosestPoint point;
};

class MeshShape final : public SolidShape {
public:
    explicit MeshShape(TriangleMesh mesh) : mesh_(std::move(mesh)), order_(mesh_.triangles.size()) {
        DRAPE_ASSERT(!mesh_.triangles.empty());
        weigh_normals();
        std::iota(order_.begin(), order_.end(), 0);
        boxes_.reserve(2 * order_.size());
        build(order_);
        for (const int t : order_) corners_.push_back({point(t, 0), point(t, 1), point(t, 2)});
    }

    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const override {
        ClosestFeature closest;
        const auto look = [&](std::size_t k) {
            const auto& [a, b, c] = corners_[k];
            const ClosestPoint found = closest_point_on_triangle(p, a, b, c);
            const Real square = (found.point - p).squaredNorm();
            if (square < closest.square) closest = {square, order_[k], found};
        };
        search(
            {0, 0, order_.size()}, closest.square, [&](const MeshBox& box) { return square_to(box, p); }, look);
        DRAPE_ASSERT(closest.triangle >= 0);
        const Vec3 feature_normal = pseudonormal(closest), offset = p - closest.point.point;
        const Real distance = std::sqrt(closest.square), sign = offset.dot(feature_normal) < 0 ? Real(-1) : Real(1);
        return {sign * distance, distance > 0 ? Vec3(sign / distance * offset) : Vec3(feature_normal.normalized())};
    }

    [[nodiscard]] Real clearance(const std::array<Vec3, 3>& triangle, Real asked) const override {
        MeshBox box;
        for (const Vec3& corner : triangle) box.extend(corner);
        Real square = asked * asked;  // less than zero, which ends the search, once the triangle is pierced
        search(
            {0, 0, order_.size()}, square, [&](const MeshBox& other) { return square_between(other, box); },
            [&](std::size_t k) { square = square_between(triangle, corners_[k], square); });
        if (square < 0) return SolidShape::clearance(triangle, asked);
        return std::sqrt(square) * (1 - bound_rounding);
    }

    [[nodiscard]] bool is_convex() const override { return false; }
    [[nodiscard]] std::array<Vec3, 2> extent() const override { return {boxes_[0].min(), boxes_[0].max()}; }

    [[nodiscard]] TriangleMesh surface() const override { return mesh_; }

private:
    static constexpr Real bound_rounding = 1024 * std::numeric_limits<Real>::epsilon();

    [[nodiscard]] const Vec3& point(int triangle, std::size_t corner) const {
        return mesh_.points[static_cast<std::size_t>(mesh_.triangles[static_cast<std::size_t>(triangle)][corner])];
    }

    [[nodiscard]] std::pair<int, int> edge(int triangle, std::size_t opposite) const {
        const auto& corners = mesh_.triangles[static_cast<std::size_t>(triangle)];
        return std::minmax(corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]);
    }

    /// The normals of triangles, the sums of both at each edge, and the means by angle at each point.
    void weigh_normals() {
        mesh_.normals.assign(mesh_.points.size(), Vec3::Zero());
        for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
            const Vec3 normal = (point(t, 1) - point(t, 0)).cross(point(t, 2) - point(t, 0)).normalized();
            triangle_normals_.push_back(normal);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 first = (point(t, (k + 1) % 3) - point(t, k)).normalized();
                const Vec3 second = (point(t, (k + 2) % 3) - point(t, k)).normalized();
                const auto corner = static_cast<std::size_t>(mesh_.triangles[static_cast<std::size_t>(t)][k]);
                mesh_.normals[corner] += angle_between(first, second) * normal;
                edge_normals_.try_emplace(edge(t, k), Vec3::Zero()).first->second += normal;
            }
        }
        for (Vec3& normal : mesh_.normals) normal.normalize();
    }

    /// The normal of the feature that is closest: a triangle, or an edge or a corner of it.
    [[nodiscard]] Vec3 pseudonormal(const ClosestFeature& closest) const {
        const std::array<Real, 3>& weights = closest.point.barycentric;
        const OnTriangle on = feature_at(weights);
        if (on.zeros == 0) return triangle_normals_[static_cast<std::size_t>(closest.triangle)];
        if (on.zeros == 1) return edge_normals_.at(edge(closest.triangle, on.opposite));
        const auto corner = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
        const auto& corners = mesh_.triangles[static_cast<std::size_t>(closest.triangle)];
        return mesh_.normals[static_cast<std::size_t>(corners[corner])];
    }

    [[nodiscard]] MeshBox box_of(int triangle) const {
        MeshBox box;
        for (std::size_t k = 0; k < 3; ++k) box.extend(point(triangle, k));
        return box;
    }

    /// Of some triangles, which it halves by the middles of their boxes along the longest side of all.
    void build(std::span<int> triangles) {
        MeshBox all;
        for (const int t : triangles) all.extend(box_of(t));
        boxes_.push_back(all);
        if (triangles.size() == 1) return;
        Eigen::Index axis = 0;
        all.sizes().maxCoeff(&axis);
        std::ranges::sort(triangles, {}, [&](int t) { return std::pair(box_of(t).center()[axis], t); });
        const std::size_t half = triangles.size() / 2;
        build(triangles.first(half));
        build(triangles.subspan(half));
    }

    /// Into both halves of a range, the nearer first, as far as their boxes are nearer than what was found.
    /// @param square of the least distance so far
    /// @param square_to square_to(box) of the distance of a box
    /// @param look look(k) at the k-th triangle of the order may find a lesser one
    template <class SquareTo, class Look>
    void search(const MeshRange& range, const Real& square, const SquareTo& square_to, const Look& look) const {
        if (range.count == 1) return look(range.first);
        auto [near, far] = range.halves();
        Real to_near = square_to(boxes_[near.box]), to_far = square_to(boxes_[far.box]);
        if (to_far < to_near) std::swap(near, far), std::swap(to_near, to_far);
        if (to_near < square) search(near, square, square_to, look);
        if (to_far < square) search(far, square, square_to, look);
    }

    TriangleMesh mesh_;
    std::vector<int> order_;                    ///< of the triangles, as the tree has them
    std::vector<std::array<Vec3, 3>> corners_;  ///< of the triangles in that order
    std::vector<MeshBox> boxes_;                ///< of ranges of it, see `MeshRange`
    std::vector<Vec3> triangle_normals_;
    std::map<std::pair<int, int>, Vec3> edge_normals_;
};

}  // namespace

std::shared_ptr<const SolidShape> make_mesh_shape(TriangleMesh mesh) {
    return std::make_shared<MeshShape>(std::move(mesh));
}

}  // namespace drape
