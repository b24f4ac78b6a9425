#include "node_states.h"

#include <algorithm>

namespace drape {

void TouchedCells::take(const Grid& grid, std::span<const ContactRow> contacts, bool tested,
                        std::span<const int> more) {
    columns_ = grid.cell_columns();
    tested_ = tested;
    cells_.assign(more.begin(), more.end());
    for (const ContactRow& contact : contacts) cells_.push_back(contact.triangle / 2);
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
}

bool TouchedCells::any_in(const CellRange& cells) const {
    for (int j = cells.j0; j < cells.j1; ++j) {
        const auto first = std::lower_bound(cells_.begin(), cells_.end(), j * columns_ + cells.i0);
        if (first != cells_.end() && *first < j * columns_ + cells.i1) return true;
    }
    return false;
}

NodeState TouchedCells::state_of(const NodeView& node) const {
    if (node.visit == NodeVisit::Unvisited) return NodeState::Unvisited;
    if (node.visit == NodeVisit::Pruned) return NodeState::Pruned;
    if (any_in(node.cells)) return NodeState::Touching;
    if (node.visit == NodeVisit::Entered) return NodeState::Visited;
    return tested_ ? NodeState::FalseCandidate : NodeState::Leaf;
}

ShownLevel shown_level(const FrameView& view) {
    ShownLevel shown;
    for (const ClothView& cloth : view.cloths) shown.levels = std::max(shown.levels, cloth.hierarchy->levels());
    shown.level = std::clamp(view.settings->view.level, 0, std::max(shown.levels - 1, 0));
    shown.all = view.settings->view.level >= shown.levels;
    return shown;
}

void nodes_of_level(const BroadPhase& hierarchy, int level, std::vector<NodeView>& nodes) {
    hierarchy.nodes_at(level, nodes);
    std::erase_if(nodes, [level](const NodeView& node) { return node.cells.level != level; });
}

std::span<const NodeView> ShownNodes::list(const FrameView& view, const BroadPhase& hierarchy) {
    all_.clear();
    const ShownLevel shown = shown_level(view);
    if (!shown.all && hierarchy.levels() > 0) {
        hierarchy.nodes_at(std::min(shown.level, hierarchy.levels() - 1), all_);
    }
    for (int level = 0; shown.all && level < hierarchy.levels(); ++level) {
        nodes_of_level(hierarchy, level, of_level_);
        all_.insert(all_.end(), of_level_.begin(), of_level_.end());
    }
    return all_;
}

void LevelCounts::add(std::span<const NodeView> added, const TouchedCells& touched) {
    nodes += static_cast<int>(added.size());
    for (const NodeView& node : added) {
        const bool overlaps = node.visit >= NodeVisit::Entered;
        const bool touches = touched.state_of(node) == NodeState::Touching;
        visited += node.visit != NodeVisit::Unvisited;
        pruned += node.visit == NodeVisit::Pruned;
        false_positives += overlaps && !touches;
        touching += touches;
    }
}

}  // namespace drape
