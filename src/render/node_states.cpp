#include "node_states.h"

#include <algorithm>

namespace drape {

std::span<const NodeLook, 6> node_looks() {
    static constexpr std::array<NodeLook, 6> looks{{{"not visited", {0.45f, 0.48f, 0.52f, 0.40f}},
                                                    {"pruned", {0.20f, 0.23f, 0.28f, 0.50f}},
                                                    {"visited", {0.00f, 0.36f, 0.75f, 0.60f}},
                                                    {"leaf, not tested yet", {0.00f, 0.50f, 0.34f, 0.65f}},
                                                    {"false candidate", {0.72f, 0.25f, 0.58f, 0.80f}},
                                                    {"touching", {1.00f, 0.76f, 0.05f, 0.85f}}}};
    return looks;
}

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

LevelCounts& LevelCounts::operator+=(const LevelCounts& other) {
    nodes += other.nodes;
    visited += other.visited;
    pruned += other.pruned;
    false_positives += other.false_positives;
    touching += other.touching;
    return *this;
}

LevelCounts counts_of(std::span<const NodeView> nodes, const TouchedCells& touched) {
    LevelCounts counts{.nodes = static_cast<int>(nodes.size())};
    for (const NodeView& node : nodes) {
        const bool overlaps = node.visit >= NodeVisit::Entered;
        const bool touches = touched.state_of(node) == NodeState::Touching;
        counts.visited += node.visit != NodeVisit::Unvisited;
        counts.pruned += node.visit == NodeVisit::Pruned;
        counts.false_positives += overlaps && !touches;
        counts.touching += touches;
    }
    return counts;
}

}  // namespace drape
