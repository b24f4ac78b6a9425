// Bounding volumes that are shown.

#include <gtest/gtest.h>

#include "drape/bounds/node_view.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

TEST(ShownHierarchy, LeavesTheBitsOfTheMotion) {
    for (const char* update : {"update=rebuild", "update=refit", "update=none", "search_level=1"}) {
        const std::string motion = "ball.motion=path", path = "ball.path=0,0,0.2,3,0.5,0,0.2,0.4,3,0,0.2,0.3";
        Simulation shown = small_simulation({path, motion, update, "view.bounds=true"});
        Simulation hidden = small_simulation({path, motion, update});
        for (int step = 0; step < 2000; ++step) {
            shown.step(), hidden.step();
            if (step % 3 == 0) static_cast<void>(shown.view());
        }
        EXPECT_GT(shown.report().contacts, 0) << update;
        EXPECT_EQ(shown.hash(), hidden.hash()) << update;
    }
}

TEST(ShownHierarchy, ShowsWhatAQueryDoesWithANewHierarchyAtOnce) {
    for (const char* change : {"set contact.sphere_fit=ritter", "set leaf_cells=3", "next update"}) {
        Simulation simulation = small_simulation({"view.bounds=true", "leaf_cells=2"});
        while (simulation.report().contacts == 0) simulation.step();
        send(simulation, "pause");
        send(simulation, change);
        std::vector<NodeView> shown;
        simulation.view().cloths[0].hierarchy->nodes_at(0, shown);
        EXPECT_EQ(shown[0].visit, NodeVisit::Entered) << change;
    }
}

}  // namespace
}  // namespace drape
