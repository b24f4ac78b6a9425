#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "drape/base/assert.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/solid_shape.h"

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

/// A node of the tree of triangles: a range of them, and their box.
struct MeshNode {
    MeshBox box;
    int first = 0, count = 0;  ///< of the order of triangles
    int left = -1;             ///< its right child follows; -1: a leaf
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
        nodes_.reserve(2 * order_.size());
        nodes_.push_back(node_of(0, static_cast<int>(order_.size())));
        split(0);
    }

    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const override {
        ClosestFeature closest;
        search(0, p, closest);
        const Vec3 feature_normal = pseudonormal(closest), offset = p - closest.point.point;
        const Real distance = std::sqrt(closest.square), sign = offset.dot(feature_normal) < 0 ? Real(-1) : Real(1);
        return {sign * distance, distance > 0 ? Vec3(sign / distance * offset) : Vec3(feature_normal.normalized())};
    }

    [[nodiscard]] bool is_convex() const override { return false; }
    [[nodiscard]] std::array<Vec3, 2> extent() const override { return {nodes_[0].box.min(), nodes_[0].box.max()}; }

    [[nodiscard]] TriangleMesh surface() const override { return mesh_; }

private:
    static constexpr int leaf_triangles = 1;

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
        const auto zeros = std::ranges::count(weights, Real(0));
        if (zeros == 0) return triangle_normals_[static_cast<std::size_t>(closest.triangle)];
        if (zeros == 1) {
            const auto opposite = static_cast<std::size_t>(std::ranges::find(weights, Real(0)) - weights.begin());
            return edge_normals_.at(edge(closest.triangle, opposite));
        }
        const auto corner = static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
        const auto& corners = mesh_.triangles[static_cast<std::size_t>(closest.triangle)];
        return mesh_.normals[static_cast<std::size_t>(corners[corner])];
    }

    [[nodiscard]] MeshBox box_of(int triangle) const {
        MeshBox box;
        for (std::size_t k = 0; k < 3; ++k) box.extend(point(triangle, k));
        return box;
    }

    [[nodiscard]] MeshNode node_of(int first, int count) const {
        MeshNode node{.box = {}, .first = first, .count = count};
        for (int k = first; k < first + count; ++k) node.box.extend(box_of(order_[static_cast<std::size_t>(k)]));
        return node;
    }

    /// Halves a node's triangles by the middles of their boxes along its longest side.
    void split(std::size_t n) {
        const auto [box, first, count, left] = nodes_[n];
        if (count <= leaf_triangles) return;
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        const auto begin = order_.begin() + first;
        std::ranges::sort(begin, begin + count, {}, [&](int t) { return std::pair(box_of(t).center()[axis], t); });
        const std::size_t child = nodes_.size();
        nodes_[n].left = static_cast<int>(child);
        nodes_.push_back(node_of(first, count / 2));
        nodes_.push_back(node_of(first + count / 2, count - count / 2));
        split(child);
        split(child + 1);
    }

    void search(std::size_t n, const Vec3& p, ClosestFeature& closest) const {
        const MeshNode& node = nodes_[n];
        if (node.left < 0) return search_leaf(node, p, closest);
        std::size_t near = static_cast<std::size_t>(node.left), far = near + 1;
        Real near_square = nodes_[near].box.squaredExteriorDistance(p);
        Real far_square = nodes_[far].box.squaredExteriorDistance(p);
        if (far_square < near_square) std::swap(near, far), std::swap(near_square, far_square);
        if (near_square < closest.square) search(near, p, closest);
        if (far_square < closest.square) search(far, p, closest);
    }

    void search_leaf(const MeshNode& node, const Vec3& p, ClosestFeature& closest) const {
        for (int k = node.first; k < node.first + node.count; ++k) {
            const int t = order_[static_cast<std::size_t>(k)];
            const ClosestPoint found = closest_point_on_triangle(p, point(t, 0), point(t, 1), point(t, 2));
            const Real square = (found.point - p).squaredNorm();
            if (square < closest.square) closest = {square, t, found};
        }
    }

    TriangleMesh mesh_;
    std::vector<int> order_;  ///< of the triangles, as the nodes have them
    std::vector<MeshNode> nodes_;
    std::vector<Vec3> triangle_normals_;
    std::map<std::pair<int, int>, Vec3> edge_normals_;
};

}  // namespace

std::shared_ptr<const SolidShape> make_mesh_shape(TriangleMesh mesh) {
    return std::make_shared<MeshShape>(std::move(mesh));
}

}  // namespace drape
