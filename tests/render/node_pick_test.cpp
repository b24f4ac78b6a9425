#include "render/node_pick.h"

#include <gmock/gmock.h>

#include "render/drawn_nodes.h"
#include "resting_cloth.h"

namespace drape {
namespace {

using testing::HasSubstr;

/// A flat cloth of 1 m at y = 0, a ball over its corner at the origin, and a camera that looks down on it.
class NodesUnderThePointer : public testing::Test {
protected:
    static constexpr int width = 800, height = 600;

    explicit NodesUnderThePointer(VolumeKind volume = VolumeKind::Sphere) {
        settings_.contact.volume = volume;
        settings_.contact.leaf_cells = 4;
        settings_.view.bounds = true;
        settings_.view.eye = Vec3(Real(0.5), 3, Real(0.6));
        settings_.view.target = Vec3(Real(0.5), 0, Real(0.5));
        tree_ = make_broad_phase(broad_phase_of(settings_), cloth_.model.grid);
        tree_->build(cloth_.x);
        balls_.push_back({Vec3::Zero(), Real(0.1), Vec3::Zero()});
        tree_->query(grown(balls_[0], settings_.contact.thickness), found_);
        report_.step = 1;
        cloth_.view.hierarchy = tree_.get();
        view_.cloths = {&cloth_.view, 1};
        view_.balls = balls_;
        view_.settings = &settings_;
        view_.report = &report_;
    }

    [[nodiscard]] std::optional<NodePick> pick(const Vec3& point) const {
        const Eigen::Vector2i at = test::pixel_of(point, Camera(settings_.view), width, height);
        return pick_node(view_, Camera(settings_.view), at.x(), at.y(), width, height);
    }

    Settings settings_;
    test::RestingCloth cloth_{{33, 33}};
    std::unique_ptr<BroadPhase> tree_;
    Candidates found_;
    std::vector<Ball> balls_;
    StepReport report_;
    FrameView view_;
};

class BoxesUnderThePointer : public NodesUnderThePointer {
protected:
    BoxesUnderThePointer() : NodesUnderThePointer(VolumeKind::Aabb) {}
};

TEST_F(BoxesUnderThePointer, AreFoundByTheClothInThem) {
    settings_.view.level = 2;  // of 16 nodes, 8 x 8 cells each
    for (const auto& [x, z] : {std::pair{0.37, 0.13}, {0.13, 0.87}, {0.63, 0.62}}) {
        const auto found = pick(Vec3(static_cast<Real>(x), 0, static_cast<Real>(z)));
        ASSERT_TRUE(found);
        EXPECT_EQ(found->node.cells.level, 2);
        EXPECT_TRUE(found->node.cells.holds(static_cast<int>(32 * x), static_cast<int>(32 * z)));
        EXPECT_EQ(found->node.cells.cells(), 64);
    }
    EXPECT_FALSE(pick(Vec3(Real(1.3), 0, Real(0.5)))) << "beside the cloth";
    EXPECT_FALSE(pick_node(view_, Camera(settings_.view), -1, 5, width, height)) << "beside the picture";
}

TEST_F(NodesUnderThePointer, SayWhoTheyAreAndWhy) {
    settings_.view.level = 2;
    std::vector<NodeView> nodes;
    nodes_of_level(*tree_, 2, nodes);
    std::set<NodeState> states;
    for (const NodeView& node : nodes) {
        const auto& sphere = std::get<BoundingSphere>(node.volume);
        const auto found = pick(sphere.centre);
        ASSERT_TRUE(found);
        states.insert(found->state);
        const std::string title = node_title(*found, view_).data(), reason = node_reason(*found, view_).data();
        const CellRange& cells = found->node.cells;
        EXPECT_EQ(title, "Level 2, node " + std::to_string(found->number) + ": columns " + std::to_string(cells.i0) +
                             "-" + std::to_string(cells.i1 - 1) + ", rows " + std::to_string(cells.j0) + "-" +
                             std::to_string(cells.j1 - 1));
        const BoundingSphere volume = std::get<BoundingSphere>(found->node.volume);
        const Real gap = volume.centre.norm() - volume.radius - Real(0.1) - settings_.contact.thickness;
        EXPECT_EQ(found->at_ball, gap <= 0);
        if (found->state == NodeState::Pruned) {
            EXPECT_FALSE(found->at_ball);
            EXPECT_EQ(reason, "pruned: no ball overlaps it");
        }
        if (found->state == NodeState::Unvisited) {
            EXPECT_THAT(reason, HasSubstr("not visited"));
        }
    }
    EXPECT_TRUE(states.contains(NodeState::Pruned));
    EXPECT_TRUE(states.contains(NodeState::Unvisited));
}

TEST_F(BoxesUnderThePointer, AreTightWhereTheyAreNoLargerThanTheSmallestSphere) {
    std::vector<NodeView> nodes;
    tree_->nodes_at(1, nodes);
    EXPECT_NEAR(tightness(nodes[0], 0, cloth_.model.grid, cloth_.x), 1, 1e-9) << "a flat square";
    const Real half = Real(0.5) * std::sqrt(Real(0.5));  // of its diagonal
    EXPECT_NEAR(tightness(nodes[0], half, cloth_.model.grid, cloth_.x), 2, 1e-9) << "slack counts";

    LevelFits fits;
    for (const LevelFit& fit : fits.look(view_, tree_->levels())) EXPECT_NEAR(fit.tightness, 1, 1e-9);
    nodes[0].volume = Aabb{Vec3(-1, 0, -1), Vec3(2, 0, 2)};
    EXPECT_NEAR(tightness(nodes[0], 0, cloth_.model.grid, cloth_.x), 6, 1e-9);
}

}  // namespace
}  // namespace drape
