#include "node_pick.h"

#include <algorithm>

#include "overlay_style.h"

namespace drape {

std::optional<NodePick> pick_node(const FrameView& view, const Camera& camera, int x, int y, int width, int height) {
    if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
    const Pick hit = pick_particle(view, camera.ray(x, y, width, height));
    if (hit.particle < 0) return std::nullopt;
    NodePick pick{};
    pick.cloth = static_cast<std::size_t>(hit.cloth);
    const ClothView& cloth = view.cloths[pick.cloth];
    const Grid& grid = cloth.model.grid;
    const int i = std::min(hit.particle % grid.nx, grid.cell_columns() - 1);
    const int j = std::min(hit.particle / grid.nx, grid.cell_rows() - 1);
    const std::vector<NodeView> shown = shown_nodes(view, *cloth.hierarchy);
    const auto holds = [&](const NodeView& node) { return node.cells.holds(i, j); };
    const auto found = std::find_if(shown.rbegin(), shown.rend(), holds);
    if (found == shown.rend()) return std::nullopt;

    pick.node = *found;
    pick.state = TouchedCells(cloth, *view.report).state_of(pick.node);
    std::vector<NodeView> nodes;
    nodes_of_level(*cloth.hierarchy, pick.node.cells.level, nodes);
    const CellRange& cells = pick.node.cells;
    const auto same = [&](const NodeView& node) { return static_cast<const CellRange&>(node.cells) == cells; };
    pick.number = static_cast<int>(std::ranges::find_if(nodes, same) - nodes.begin());
    const Real room = view.settings->contact.thickness + cloth.hierarchy->slack();
    pick.at_ball = std::ranges::any_of(view.balls, [&](const Ball& ball) {
        return std::visit([&](const auto& volume) { return volume.overlaps(grown(ball, room)); }, pick.node.volume);
    });
    return pick;
}

std::string node_title(const NodePick& pick, const FrameView& view) {
    const QuadtreeNode& cells = pick.node.cells;
    const std::string cloth = "Cloth " + std::to_string(pick.cloth) + ", level ";
    return (view.cloths.size() > 1 ? cloth : "Level ") + format("%d, node %d: columns %d-%d, rows %d-%d", cells.level,
                                                                pick.number, cells.i0, cells.i1 - 1, cells.j0,
                                                                cells.j1 - 1);
}

std::string node_reason(const NodePick& pick, const FrameView& view) {
    std::vector<NodeView> root;
    view.cloths[pick.cloth].hierarchy->nodes_at(0, root);
    if (root.front().visit == NodeVisit::Unvisited) return "not searched";
    switch (pick.state) {
        case NodeState::Unvisited:
            return "not visited: a node above it was pruned";
        case NodeState::Pruned:
            return std::string("pruned: no ") + (view.balls.empty() ? "other cloth" : "ball") + " overlaps it";
        case NodeState::Touching:
            return "touching: there are contacts in it";
        default:
            break;
    }
    const std::string what = pick.node.visit == NodeVisit::Leaf ? "leaf: " : "visited: ";
    const char* near = view.balls.empty() ? "cloth is near" : "a ball is near";
    const char* outcome = pick.state == NodeState::Untested ? "" : "; nothing in it touches";
    return what + (pick.at_ball ? "a ball overlaps it" : near) + outcome;
}

}  // namespace drape
