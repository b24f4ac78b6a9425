#include "drape/bounds/node_view.h"

#include <gtest/gtest.h>

#include "support/cloths.h"

namespace drape {
namespace {

TEST(RefitNodes, GivesEachLevelTheVolumesOfABuild) {
    const Grid grid{23, 17};
    std::mt19937 random(23);
    const Points before = test::random_cloth(grid, random), now = test::random_cloth(grid, random);
    for (std::size_t kind = 0; kind < names_of<VolumeKind>().size(); ++kind) {
        const BroadPhaseParameters parameters{.volume = static_cast<VolumeKind>(kind), .leaf_cells = 3};
        const auto built = make_broad_phase(parameters, grid), old = make_broad_phase(parameters, grid);
        built->build(now);
        old->build(before);
        for (int level = 0; level < built->levels(); ++level) {
            std::vector<NodeView> nodes, refitted;
            built->nodes_at(level, nodes);
            old->nodes_at(level, refitted);
            refit_nodes(parameters, grid, now, refitted);
            const auto sphere_of = [](const NodeView& node) {
                return std::visit([](const auto& volume) { return volume.sphere(); }, node.volume);
            };
            ASSERT_EQ(refitted.size(), nodes.size());
            for (std::size_t n = 0; n < nodes.size(); ++n) {
                const BoundingSphere expected = sphere_of(nodes[n]), found = sphere_of(refitted[n]);
                const std::string which = names_of<VolumeKind>()[kind] + ", level " + std::to_string(level);
                EXPECT_NEAR((found.centre - expected.centre).norm(), 0, 1e-9) << which;
                EXPECT_NEAR(found.radius, expected.radius, 1e-9) << which;
            }
        }
    }
}

}  // namespace
}  // namespace drape
