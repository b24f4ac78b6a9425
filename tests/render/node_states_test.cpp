#include "render/drawn_nodes.h"

#include <gtest/gtest.h>

#include "resting_cloth.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// Against a search of every cell.
TEST(TouchedCells, AreFoundInEveryRectangle) {
    const Grid grid{7, 6};
    for (int touched = 0; touched < grid.cells(); ++touched) {
        ContactRow contact;
        contact.triangle = 2 * touched + touched % 2;
        const TouchedCells cells(grid, {&contact, 1}, true);
        for (int i0 = 0; i0 < 6; i0 += 2) {
            for (int j0 = 0; j0 < 5; ++j0) {
                const CellRange range{i0, j0, i0 + 2, j0 + 1};
                EXPECT_EQ(cells.any_in(range), range.holds(touched % 6, touched / 6)) << touched;
            }
        }
    }
}

/// What a query says of itself is what its nodes say, over all levels.
TEST(LevelCounts, SumUpToWhatTheQueryDid) {
    std::mt19937 random(7);
    const Grid grid{40, 33};
    for (int round = 0; round < 20; ++round) {
        const Points x = test::random_cloth(grid, random);
        const auto tree = make_broad_phase({.volume = VolumeKind::Aabb, .leaf_cells = 4}, grid);
        tree->build(x);
        Candidates found;
        const Ball ball{.centre = x.row(round * 7), .radius = Real(0.1)};
        const TraversalStats stats = tree->query(ball, found);
        ContactRow contact;
        contact.triangle = 2 * grid.cell(found.cells.front().i0, found.cells.front().j0);
        const TouchedCells touched(grid, {&contact, 1}, true);

        LevelCounts all;
        std::vector<NodeView> nodes;
        for (int level = 0; level < tree->levels(); ++level) {
            nodes_of_level(*tree, level, nodes);
            const int before = all.touching;
            all.add(nodes, touched);
            EXPECT_LE(all.touching, before + 1) << "one cell is in one node of a level";
        }
        EXPECT_EQ(all.nodes, stats.nodes);
        EXPECT_EQ(all.visited, stats.visited);
        EXPECT_EQ(all.pruned, stats.pruned);
        EXPECT_EQ(all.visited, all.pruned + all.false_positives + all.touching);
    }
}

TEST(ShownNodes, AreThoseOfTheLevelOrPastTheFinestAll) {
    test::RestingCloth cloth({17, 17});
    const auto tree = make_broad_phase({.volume = VolumeKind::Aabb, .leaf_cells = 4}, cloth.model.grid);
    tree->build(cloth.x);
    cloth.view.hierarchy = tree.get();
    Settings settings;
    FrameView view;
    view.cloths = {&cloth.view, 1};
    view.settings = &settings;
    std::size_t all = 0;
    for (int level = 0; level < tree->levels(); ++level) {
        settings.view.level = level;
        const std::vector<NodeView> shown = shown_nodes(view, *tree);
        for (const NodeView& node : shown) EXPECT_EQ(node.cells.level, level);
        all += shown.size();
    }
    settings.view.level = tree->levels();
    EXPECT_EQ(shown_nodes(view, *tree).size(), all);
}

}  // namespace
}  // namespace drape
