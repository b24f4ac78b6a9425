// What the stats panel has rows for, seen from its height.

#include <gtest/gtest.h>

#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "render/overlay_panels.h"

namespace drape {
namespace {

class CompactPanel : public testing::Test {
protected:
    CompactPanel() { settings_.view.panel = PanelSize::Compact; }

    [[nodiscard]] float height() {
        FrameView view = simulation_.view();
        view.settings = &settings_;
        panels_.build(view, Camera(settings_.view), {}, {}, 1280, 720);
        return panels_.boxes().front().bottom;
    }

    Simulation simulation_{"drop", load_scene("drop")};
    Settings settings_ = simulation_.settings();
    OverlayPanels panels_;
};

TEST_F(CompactPanel, CountsPairsOfClothThatMeetsItself) {
    settings_.contact.self = false;
    const float without = height();
    settings_.contact.self = true;
    EXPECT_GT(height(), without);
}

TEST_F(CompactPanel, HasTheEnergyBalanceThatTheUserAsksFor) {
    settings_.solver.ledger = false;
    const float without = height();
    settings_.solver.ledger = true;
    const float row = 15;
    EXPECT_GT(height(), without + 9 * row);
}

}  // namespace
}  // namespace drape
