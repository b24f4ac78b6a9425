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

/// The pointer and what is drawn, in the picture, and of the lines so far the one that is nearest to the pointer.
struct Pointed {
    Eigen::Matrix4f projection;
    Vec3 eye;
    Eigen::Vector2f size, pointer;          // [pixel]
    float least_distance = catch_distance;  // [pixel]
    float least_depth = std::numeric_limits<float>::infinity();

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

    /// Whether a line that is seen is nearer than those before it, or as near and before them.
    [[nodiscard]] bool nears(const Vec3& from, const Vec3& to) {
        const auto a = project(from), b = project(to);
        if (!a || !b) return false;
        const Eigen::Vector2f along = b->at - a->at;
        const float length = along.squaredNorm();
        const float part = length > 0 ? std::clamp((pointer - a->at).dot(along) / length, 0.0f, 1.0f) : 0;
        const float distance = (a->at + part * along - pointer).norm(), depth = a->depth + part * (b->depth - a->depth);
        const bool nearer = distance < least_distance - 1 || (distance < least_distance && depth < least_depth);
        if (nearer) least_distance = distance, least_depth = depth;
        return nearer;
    }

    /// The same for the circles of a sphere, as shaders/bounding_sphere.vert draws them.
    [[nodiscard]] bool nears(const Outlines::Sphere& sphere) {
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
        bool nearer = false;
        for (int circle = 0; circle < 4; ++circle) {
            for (int k = 0; k < circle_segments; ++k) nearer |= nears(point(circle, k), point(circle, k + 1));
        }
        return nearer;
    }
};

bool has_nearer_line(const NodeView& node, Real slack, Pointed& pointed) {
    BoundingSphere about = std::visit([](const auto& volume) { return volume.sphere(); }, node.volume);
    about.radius += slack;
    if (pointed.is_beside(about)) return false;
    Outlines outlines;
    append_outline(node.volume, slack, NodeState::Unvisited, outlines);
    bool nearer = false;
    for (const Outlines::Sphere& sphere : outlines.spheres) nearer |= pointed.nears(sphere);
    for (const Outlines::Edge& edge : outlines.edges) nearer |= pointed.nears(edge.from, edge.to);
    return nearer;
}

std::optional<NodePick> node_on_cloth(const FrameView& view, const Ray& ray) {
    const Pick hit = pick_particle(view, ray);
    if (hit.particle < 0) return std::nullopt;
    const auto number = static_cast<std::size_t>(hit.cloth);
    const ClothView& cloth = view.cloths[number];
    const Grid& grid = cloth.model.grid;
    const int i = std::min(hit.particle % grid.nx, grid.cell_columns() - 1);
    const int j = std::min(hit.particle / grid.nx, grid.cell_rows() - 1);
    const std::vector<NodeView> shown = shown_nodes(view, *cloth.hierarchy);
    const auto holds = [&](const NodeView& node) { return node.cells.holds(i, j); };
    const auto found = std::find_if(shown.rbegin(), shown.rend(), holds);
    if (found == shown.rend()) return std::nullopt;
    return NodePick{.cloth = number, .node = *found};
}

void complete(const FrameView& view, NodePick& pick) {
    const ClothView& cloth = view.cloths[pick.cloth];
    pick.state = TouchedCells(cloth, *view.report).state_of(pick.node);
    std::vector<NodeView> nodes;
    nodes_of_level(*cloth.hierarchy, pick.node.cells.level, nodes);
    const CellRange& cells = pick.node.cells;
    const auto same = [&](const NodeView& node) { return static_cast<const CellRange&>(node.cells) == cells; };
    pick.number = static_cast<int>(std::ranges::find_if(nodes, same) - nodes.begin());
    pick.gap = std::numeric_limits<Real>::infinity();
    const Real room = view.settings->contact.thickness + cloth.hierarchy->slack();
    for (const Ball& ball : view.balls) {
        pick.gap = std::min(pick.gap, gap_to_ball(pick.node.volume, grown(ball, room)));
    }
}

}  // namespace

std::optional<NodePick> pick_node(const FrameView& view, const Camera& camera, int x, int y, int width, int height) {
    if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    Pointed pointed{camera.projection_matrix(aspect) * camera.view_matrix(),
                    camera.eye().cast<Real>(),
                    {static_cast<float>(width), static_cast<float>(height)},
                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}};
    std::optional<NodePick> best;
    for (std::size_t c = 0; c < view.cloths.size(); ++c) {
        const BroadPhase& hierarchy = *view.cloths[c].hierarchy;
        for (const NodeView& node : shown_nodes(view, hierarchy)) {
            if (has_nearer_line(node, hierarchy.slack(), pointed)) best = {.cloth = c, .node = node};
        }
    }
    if (!best) best = node_on_cloth(view, camera.ray(x, y, width, height));
    if (best) complete(view, *best);
    return best;
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
