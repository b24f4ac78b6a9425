// Nodes of searches, as they are shown.

#include <gtest/gtest.h>

#include <algorithm>

#include "drape/bounds/node_view.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

/// Without its balls what is marked is the pairs' alone.
Simulation shown_scene(const std::string& name, bool with_balls = false) {
    Settings settings = shipped_settings(name, {"view.bounds=true"});
    if (!with_balls) settings.balls.clear();
    return {name, std::move(settings)};
}

std::int64_t nodes_with(const ClothView& cloth, NodeVisit visit) {
    std::int64_t count = 0;
    std::vector<NodeView> nodes;
    for (int level = 0; level < cloth.hierarchy->levels(); ++level) {
        cloth.hierarchy->nodes_at(level, nodes);
        count += std::ranges::count_if(
            nodes, [&](const NodeView& node) { return node.cells.level == level && node.visit == visit; });
    }
    return count;
}

/// A search leaves out no child of a node that it has entered, and goes nowhere else.
void expect_all_children_visited(const ClothView& cloth) {
    std::vector<NodeView> parents, nodes;
    int entered = 0;
    for (int level = 1; level < cloth.hierarchy->levels(); ++level) {
        cloth.hierarchy->nodes_at(level - 1, parents);
        cloth.hierarchy->nodes_at(level, nodes);
        for (const NodeView& node : nodes) {
            if (node.cells.level != level) continue;
            const auto parent = std::ranges::find_if(
                parents, [&](const NodeView& one) { return one.cells.holds(node.cells.i0, node.cells.j0); });
            ASSERT_NE(parent, parents.end());
            entered += parent->visit == NodeVisit::Entered;
            EXPECT_EQ(node.visit != NodeVisit::Unvisited, parent->visit == NodeVisit::Entered)
                << "level " << level << ", from cell " << node.cells.i0 << ", " << node.cells.j0;
        }
    }
    EXPECT_GT(entered, 0);
}

/// Steps until cloth meets cloth.
void run_to_pairs(Simulation& simulation) {
    while (simulation.report().pairs == 0 && simulation.report().time < 1) simulation.step();
    ASSERT_GT(simulation.report().pairs, 0);
}

TEST(PairMarks, AreOnEveryChildOfANodeThatWasEntered) {
    Simulation simulation = shown_scene("stack");
    run_to_pairs(simulation);
    const FrameView view = simulation.view(1);
    for (const ClothView& cloth : view.cloths) expect_all_children_visited(cloth);
}

TEST(PairMarks, ShowASheetThatCannotTouchItselfPrunedAtTheRootAndSheetsThatTouchVisited) {
    Simulation hanging = shown_scene("fold");
    const FrameView flat = hanging.view(1);
    EXPECT_EQ(nodes_with(flat.cloths[0], NodeVisit::Pruned), 1);
    EXPECT_EQ(nodes_with(flat.cloths[0], NodeVisit::Entered), 0);
    EXPECT_TRUE(flat.cloths[0].pair_cells.empty());

    Simulation simulation = shown_scene("stack");
    run_to_pairs(simulation);
    const FrameView touching = simulation.view(1);
    EXPECT_GT(nodes_with(touching.cloths[0], NodeVisit::Entered), 0);
    EXPECT_GT(nodes_with(touching.cloths[0], NodeVisit::Leaf), 0);
    EXPECT_GT(touching.pair_search.leaves, 0);
    EXPECT_FALSE(touching.cloths[0].pair_cells.empty());
}

/// The counts of a step's report are those of the nodes that are shown, though cloth meets cloth there too.
TEST(BallMarks, AreThoseOfTheReport) {
    for (const char* scene : {"veil", "fold"}) {
        SCOPED_TRACE(scene);
        Simulation simulation = shown_scene(scene, true);
        run_to_pairs(simulation);
        const FrameView view = simulation.view(1);
        const TraversalStats& of_step = view.report->traversal;
        const ClothView& cloth = view.cloths[0];
        const auto visited = [&](NodeVisit visit) { return nodes_with(cloth, visit); };
        EXPECT_GT(of_step.pruned, 0);
        EXPECT_EQ(visited(NodeVisit::Pruned), of_step.pruned);
        EXPECT_EQ(visited(NodeVisit::Leaf), of_step.leaves);
        EXPECT_EQ(visited(NodeVisit::Pruned) + visited(NodeVisit::Leaf) + visited(NodeVisit::Entered),
                  of_step.volume_tests);
        EXPECT_EQ(view.pair_search.visited, 0);
    }
}

TEST(ShownHierarchy, LeavesTheBitsOfTheMotion) {
    const std::string motion = "ball.motion=path", path = "ball.path=0,0,0.2,3,0.5,0,0.2,0.4,3,0,0.2,0.3";
    for (const char* update : {"update=rebuild", "update=refit", "update=none", "search_level=1"}) {
        Simulation shown = small_simulation({path, motion, update, "view.bounds=true"});
        Simulation hidden = small_simulation({path, motion, update});
        for (int step = 0; step < 2000; ++step) {
            shown.step(), hidden.step();
            if (step % 3 == 0) static_cast<void>(shown.view());
        }
        EXPECT_GT(shown.report().contacts, 0) << update;
        EXPECT_EQ(shown.hash(), hidden.hash()) << update;
    }
    // Of pairs of cloths too, which are marked only where they are shown
    Simulation shown = shown_scene("stack"), hidden = shown_scene("stack");
    send(hidden, "set view.bounds=false");
    for (int step = 0; step < 200; ++step) {
        shown.step(), hidden.step();
        if (step % 10 > 0) continue;
        EXPECT_GT(shown.view(1).pair_search.visited, 0);
        EXPECT_EQ(hidden.view(1).pair_search.visited, 0);
    }
    EXPECT_EQ(shown.hash(), hidden.hash());
}

}  // namespace
}  // namespace drape
