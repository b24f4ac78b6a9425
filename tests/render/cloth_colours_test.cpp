#include "render/cloth_colours.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace drape {
namespace {

/// A square cloth of side 1 m, to be moved by hand, seen with a hierarchy at rest.
class ClothColoursTest : public testing::Test {
protected:
    void make(const Grid& grid, int leaf_cells = 4) {
        settings_.cloths[0].particles = grid;
        model_ = make_cloth_model(settings_.cloths[0]);
        x_ = make_rest_state(settings_.cloths[0]).x;
        v_ = Points::Zero(x_.rows(), 3);
        tree_ = make_broad_phase({.volume = VolumeKind::Aabb, .leaf_cells = leaf_cells}, grid);
        tree_->build(x_);
    }

    std::vector<float> values_by(ColourBy by) {
        settings_.view.colour = by;
        const ClothView cloth{model_, x_, x_, contacts_, tree_.get(), &v_};
        FrameView view;
        view.cloths = {&cloth, 1};
        view.settings = &settings_;
        colours_ = cloth_colours(view);
        return colours_.values;
    }

    Settings settings_;
    ClothModel model_;
    Points x_, v_;
    std::vector<ContactRow> contacts_;
    std::unique_ptr<BroadPhase> tree_;
    ClothColours colours_;
};

TEST_F(ClothColoursTest, ShowTheStrainOfTheLongestSpringInPercent) {
    make({5, 4});
    x_.col(0) *= Real(1.03);
    for (const float value : values_by(ColourBy::Strain)) EXPECT_NEAR(value, 3.0 / 5, 1e-4);
    EXPECT_EQ(colours_.scale.most, 5);
    EXPECT_EQ(colours_.scale.unit, "%");
    x_.col(0) *= Real(0.9 / 1.03);
    for (const float value : values_by(ColourBy::Strain)) EXPECT_NEAR(value, 0, 1e-2) << "compressed";
}

TEST_F(ClothColoursTest, ShowTheSpeed) {
    make({3, 3});
    v_.row(4) = Vec3(0, -12, 5).transpose();
    v_.row(8) = Vec3(0, 0, 2).transpose();
    const std::vector<float> values = values_by(ColourBy::Speed);
    EXPECT_EQ(colours_.scale.most, 20);
    EXPECT_FLOAT_EQ(values[4], 13.0f / 20);
    EXPECT_FLOAT_EQ(values[8], 2.0f / 20);
    EXPECT_EQ(values[0], 0);
    EXPECT_TRUE(values_by(ColourBy::Plain).empty());
    v_(4, 0) = std::numeric_limits<Real>::infinity();
    values_by(ColourBy::Speed);
    EXPECT_EQ(colours_.scale.most, 1) << "a round scale for what is not finite";
}

TEST_F(ClothColoursTest, ShowTheDepthOfTheDeepestContactInMillimetres) {
    make({3, 3});
    for (const double depth : {0.5e-3, 1.5e-3}) {
        ContactRow contact;
        contact.count = 3;
        contact.particles = {{{0, 0, Real(0.5)}, {0, 3, Real(0.5)}, {0, 1, 0}}};
        contact.depth = static_cast<Real>(depth);
        contacts_.push_back(contact);
    }
    const std::vector<float> values = values_by(ColourBy::Depth);
    EXPECT_EQ(colours_.scale.most, 2);
    EXPECT_EQ(colours_.scale.unit, "mm");
    EXPECT_FLOAT_EQ(values[0], 0.75f);
    EXPECT_FLOAT_EQ(values[3], 0.75f);
    EXPECT_EQ(values[1], 0) << "no weight there";
}

/// A cell takes the value of its corner b.
TEST_F(ClothColoursTest, TellNeighbouringNodesApart) {
    for (const Grid grid : {Grid{17, 40}, Grid{65, 33}}) {
        for (const int level : {0, 2, 9}) {
            make(grid);
            settings_.view.level = level;
            const std::vector<float> values = values_by(ColourBy::Level);
            std::vector<NodeView> nodes;
            tree_->nodes_at(level, nodes);
            const auto node_of = [&](int i, int j) {
                return std::ranges::find_if(nodes, [&](const NodeView& node) { return node.cells.holds(i, j); });
            };
            const auto value = [&](int i, int j) { return values[static_cast<std::size_t>(grid.particle(i + 1, j))]; };
            for (int j = 0; j < grid.cell_rows(); ++j) {
                for (int i = 0; i < grid.cell_columns(); ++i) {
                    for (const auto& [right, down] : {std::pair{1, 0}, {0, 1}}) {
                        if (i + right >= grid.cell_columns() || j + down >= grid.cell_rows()) continue;
                        const bool same = node_of(i, j) == node_of(i + right, j + down);
                        ASSERT_EQ(value(i, j) == value(i + right, j + down), same)
                            << grid.nx << " x " << grid.ny << ", level " << level << ", cell " << i << ", " << j;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace drape
