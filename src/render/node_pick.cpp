#include "node_pick.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "overlay_style.h"

namespace drape {

namespace {

constexpr float catch_distance = 6;  // pixels
constexpr int circle_segments = 24;

/// A point of the picture, from its upper left [pixel], and how far behind the eye it lies.
struct ScreenPoint {
    Eigen::Vector2f at;
    float depth;
};

// "3.2 cm"
std::string length_text(Real length) {
    const auto metres = static_cast<double>(length);
    if (metres < 0.01) return format("%.1f mm", 1000 * metres);
    return metres < 1 ? format("%.1f cm", 100 * metres) : format("%.2f m", metres);
}

}  // namespace

/// The pointer and what is drawn, in the picture.
struct NodePicker::Pointed {
    Eigen::Matrix4f projection;
    Vec3 eye;
    Eigen::Vector2f size, pointer;  // [pixel]

    /// @return nothing behind the eye
    [[nodiscard]] std::optional<ScreenPoint> project(const Vec3& point) const {
        const Eigen::Vector4f clip = projection * point.cast<float>().homogeneous();
        if (clip.w() <= 1e-4f) return std::nullopt;
        const Eigen::Vector2f unit(clip.x() / clip.w(), -clip.y() / clip.w());
        return ScreenPoint{(unit.array() + 1) / 2 * size.array(), clip.w()};
    }

    /// Whether the pointer is so far beside a sphere that no line in it is near.
    [[nodiscard]] bool is_beside(const BoundingSphere& sphere) const {
        const auto centre = project(sphere.centre);
        const auto radius = static_cast<float>(sphere.radius);
        if (!centre || centre->depth <= 1.5f * radius) return false;
        // The height of the picture is that of 2 / projection(1, 1) at depth 1
        const float focus = projection.row(1).head<3>().norm() * size.y() / 2;
        return (centre->at - pointer).norm() > focus * radius / (centre->depth - radius) + catch_distance;
    }

    /// Calls take(distance, depth) for a line that is seen [pixel].
    template <class Take>
    void measure(const Vec3& from, const Vec3& to, Take take) const {
        const auto a = project(from), b = project(to);
        if (!a || !b) return;
        const Eigen::Vector2f along = b->at - a->at;
        const float length = along.squaredNorm();
        const float part = length > 0 ? std::clamp((pointer - a->at).dot(along) / length, 0.0f, 1.0f) : 0;
        take((a->at + part * along - pointer).norm(), a->depth + part * (b->depth - a->depth));
    }

    /// The same for the circles of a sphere, as shaders/bounding_sphere.vert draws them.
    template <class Take>
    void measure(const Outlines::Sphere& sphere, Take take) const {
        const Vec3 from = (eye - sphere.centre) / sphere.radius;
        const Real far = std::max(from.norm(), Real(1.001));
        const Vec3 ahead = from / far;
        const Vec3 side = ahead.cross(std::abs(ahead.y()) < Real(0.9) ? Vec3::UnitY() : Vec3::UnitX()).normalized();
        const Real rim = std::sqrt(1 - 1 / (far * far));
        const auto point = [&](int circle, int k) -> Vec3 {
            const Real angle = 2 * std::numbers::pi_v<Real> * static_cast<Real>(k) / circle_segments;
            const Real u = std::cos(angle), v = std::sin(angle);
            const std::array<Vec3, 4> unit{Vec3(u, v, 0), Vec3(0, u, v), Vec3(v, 0, u),
                                           ahead / far + rim * (u * side + v * ahead.cross(side))};
            return sphere.centre + sphere.radius * unit[static_cast<std::size_t>(circle)];
        };
        for (int circle = 0; circle < 4; ++circle) {
            for (int k = 0; k < circle_segments; ++k) measure(point(circle, k), point(circle, k + 1), take);
        }
    }
};

std::optional<NodePick> NodePicker::pick(const FrameView& view, const Camera& camera, int x, int y, int width,
                                         int height) {
    if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const Pointed pointed{camera.projection_matrix(aspect) * camera.view_matrix(),
                          camera.eye().cast<Real>(),
                          {static_cast<float>(width), static_cast<float>(height)},
                          {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}};
    best_.reset();
    best_distance_ = catch_distance;
    best_depth_ = std::numeric_limits<float>::infinity();
    for (std::size_t c = 0; c < view.cloths.size(); ++c) {
        look_for_lines(pointed, shown_.list(view, *view.cloths[c].hierarchy), view.cloths[c], c);
    }
    if (!best_) best_ = node_on_cloth(view, camera.ray(x, y, width, height));
    if (best_) complete(view, *best_);
    return best_;
}

void NodePicker::look_for_lines(const Pointed& pointed, std::span<const NodeView> shown, const ClothView& cloth,
                                std::size_t number) {
    for (const NodeView& node : shown) {
        BoundingSphere about = std::visit([](const auto& volume) { return volume.sphere(); }, node.volume);
        about.radius += cloth.hierarchy->slack();
        if (pointed.is_beside(about)) continue;
        outlines_.clear();
        touched_.take(cloth.model.grid, {}, false);
        append_nodes({&node, 1}, cloth.hierarchy->slack(), touched_, outlines_);
        const auto take = [&](float distance, float depth) {
            // Of lines that are as near, the one in front
            const bool nearer = distance < best_distance_ - 1 || (distance < best_distance_ && depth < best_depth_);
            if (!nearer) return;
            best_distance_ = distance;
            best_depth_ = depth;
            best_ = {.cloth = number, .node = node};
        };
        for (const Outlines::Sphere& sphere : outlines_.spheres) pointed.measure(sphere, take);
        for (const Outlines::Edge& edge : outlines_.edges) pointed.measure(edge.from, edge.to, take);
    }
}

std::optional<NodePick> NodePicker::node_on_cloth(const FrameView& view, const Ray& ray) {
    const Pick hit = pick_particle(view, ray);
    if (hit.particle < 0) return std::nullopt;
    const auto number = static_cast<std::size_t>(hit.cloth);
    const ClothView& cloth = view.cloths[number];
    const Grid& grid = cloth.model.grid;
    const int i = std::min(hit.particle % grid.nx, grid.cell_columns() - 1);
    const int j = std::min(hit.particle / grid.nx, grid.cell_rows() - 1);
    const std::span<const NodeView> shown = shown_.list(view, *cloth.hierarchy);
    const auto holds = [&](const NodeView& node) { return node.cells.holds(i, j); };
    const auto found = std::find_if(shown.rbegin(), shown.rend(), holds);
    if (found == shown.rend()) return std::nullopt;
    return NodePick{.cloth = number, .node = *found};
}

void NodePicker::complete(const FrameView& view, NodePick& pick) {
    const ClothView& cloth = view.cloths[pick.cloth];
    touched_.take(cloth, *view.report);
    pick.state = touched_.state_of(pick.node);
    nodes_of_level(*cloth.hierarchy, pick.node.cells.level, nodes_);
    const CellRange& cells = pick.node.cells;
    const auto same = [&](const NodeView& node) { return static_cast<const CellRange&>(node.cells) == cells; };
    pick.number = static_cast<int>(std::ranges::find_if(nodes_, same) - nodes_.begin());
    pick.gap = std::numeric_limits<Real>::infinity();
    const Real room = view.settings->contact.thickness + cloth.hierarchy->slack();
    for (const Ball& ball : view.balls) {
        pick.gap = std::min(pick.gap, gap_to_ball(pick.node.volume, grown(ball, room)));
    }
}

Real gap_to_ball(const AnyVolume& volume, const Ball& ball) {
    const auto overlaps = [&](Real gap) {
        return std::visit([&](const auto& v) { return v.overlaps(grown(ball, gap)); }, volume);
    };
    Real apart = -ball.radius, together = ball.radius;
    if (overlaps(apart)) return apart;
    while (!overlaps(together)) together *= 2;
    for (int halving = 0; halving < 40; ++halving) {
        const Real middle = (apart + together) / 2;
        (overlaps(middle) ? together : apart) = middle;
    }
    return together;
}

std::string node_title(const NodePick& pick, const FrameView& view) {
    const QuadtreeNode& cells = pick.node.cells;
    const std::string cloth = "Cloth " + std::to_string(pick.cloth) + ", level ";
    return (view.cloths.size() > 1 ? cloth : "Level ") + format("%d, node %d: columns %d-%d, rows %d-%d", cells.level,
                                                                pick.number, cells.i0, cells.i1 - 1, cells.j0,
                                                                cells.j1 - 1);
}

std::string node_reason(const NodePick& pick, const FrameView& view) {
    const bool has_ball = !view.balls.empty();
    const std::string ball = view.balls.size() == 1 ? "the ball" : "the nearest ball";
    const std::string length = length_text(std::abs(pick.gap));
    std::vector<NodeView> root;
    view.cloths[pick.cloth].hierarchy->nodes_at(0, root);
    if (root.front().visit == NodeVisit::Unvisited) return "not searched";
    switch (pick.state) {
        case NodeState::Unvisited:
            return "not visited: a node above it was pruned";
        case NodeState::Pruned:
            if (!has_ball) return "pruned: no other cloth is near";
            return "pruned: " + length + " beyond " + ball + (view.settings->contact.self ? ", and no cloth near" : "");
        case NodeState::Touching:
            return "touching: there are contacts in it";
        default:
            break;
    }
    const std::string what = pick.state == NodeState::Visited ? "visited: " : "leaf, cells tested: ";
    const char* outcome = pick.state == NodeState::FalseCandidate ? "; none touches" : "";
    if (has_ball && pick.gap <= 0) return what + "overlaps " + ball + " by " + length + outcome;
    return what + "cloth is near" + outcome;
}

}  // namespace drape
