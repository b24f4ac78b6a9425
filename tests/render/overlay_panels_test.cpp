// With everything on, no panel lies on another or is cut by the edge of the picture, at any size.

#include "render/overlay_panels.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drape/scene/scene.h"
#include "drape/session/comparison.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

class PanelBoxes : public testing::Test {
protected:
    PanelBoxes() : simulation_("drop", load_scene("drop")) {
        simulation_.step();
        panels_.settings.set_scene(simulation_.settings());
        settings_ = simulation_.settings();
        settings_.view.bounds = true;
        settings_.view.level = 30;
        settings_.solver.ledger = true;
        panels_.help.assign(36, {"Left, A, Right, D", "Ball left, right, away from you, towards you"});
    }

    /// As long as the stops of the tour.
    void give_hint() {
        panels_.hint = {
            {"12 of 12", "No more than needed"},
            {"See",
             "Both cloths move alike, and the one with a quarter of the particles takes a tenth of the time: "
             "a scene should model no more than what it shows."},
            {"Try", "M, Cloth, particles: with ever fewer of them the folds go first, and the outline last."},
            {"Source", "src/lab/needs/needs.cpp"},
            {"F1, F2, Esc", "Next stop, previous stop, end of the tour"}};
    }

    const std::vector<PanelBox>& boxes(PictureSize size, const std::vector<std::string>& notices) {
        FrameView view = simulation_.view();
        view.settings = &settings_;
        FrameReport report;
        panels_.colours.by = ColourBy::Strain;
        if (compares_) {
            compared_ = comparison_.view(simulation_);
            view.comparison = &compared_;
        }
        if (compares_ || in_past_) {
            view.timeline = {.oldest = 0, .now = 50, .newest = 100, .back = 0.05, .kept = 0.1};
        }
        const Camera camera(settings_.view);
        for (int frame = 0; frame < 2; ++frame) panels_.build(view, camera, report, notices, size.width, size.height);
        return panels_.boxes();
    }

    void expect_apart(PictureSize size, const std::vector<std::string>& notices) {
        const std::vector<PanelBox>& all = boxes(size, notices);
        SCOPED_TRACE(size_text(size) + ", text " + std::to_string(settings_.view.text_scale) + ", controls " +
                     std::to_string(settings_.view.controls) + ", plots " + std::to_string(settings_.view.plots) +
                     ", help " + std::to_string(settings_.view.help));
        for (std::size_t i = 0; i < all.size(); ++i) {
            const PanelBox& box = all[i];
            EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.right <= static_cast<float>(size.width) &&
                        box.bottom <= static_cast<float>(size.height))
                << i << ": " << box.left << ", " << box.top << " to " << box.right << ", " << box.bottom;
            for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(box, all[k])) << k << " and " << i;
        }
    }

    Simulation simulation_;
    Settings settings_;
    Comparison comparison_{simulation_, "solver.integrator=backward_euler"};
    ComparisonView compared_;
    bool compares_ = false, in_past_ = false;
    OverlayPanels panels_;
};

const PictureSize picture_shapes[] = {{640, 480}, {1280, 720}, {3840, 2160}};

TEST_F(PanelBoxes, AreApartAndWithinThePictureAtEverySize) {
    give_hint();
    const std::vector<std::string> notice{
        "Diverged at step 242 (RK4): particle 103 (column 7, row 6) at 520 m/s, its structural spring to 102"};
    for (const PictureSize& size : picture_shapes) {
        for (const double scale : {0.5, 1.0, 4.0}) {
            for (int on = 0; on < 32; ++on) {
                settings_.view.text_scale = scale;
                settings_.view.controls = (on & 1) != 0;
                settings_.view.plots = (on & 2) != 0;
                settings_.view.help = (on & 4) != 0;
                settings_.view.panel = (on & 8) != 0 ? PanelSize::Full : PanelSize::Compact;
                compares_ = (on & 16) != 0;
                expect_apart(size, on % 3 == 0 ? notice : std::vector<std::string>{});
            }
        }
    }
}

TEST_F(PanelBoxes, HaveANoticeBetweenThemWhereTheRoomIsNarrow) {
    settings_.view.controls = true;
    settings_.view.panel = PanelSize::Full;
    settings_.view.bounds = false;
    in_past_ = true;
    expect_apart({640, 480}, {});
    const std::size_t others = panels_.boxes().size();
    expect_apart({640, 480}, {"The scene is slower than view.speed asks: 1.6 s behind so far"});
    EXPECT_EQ(panels_.boxes().size(), others + 1);
}

TEST_F(PanelBoxes, HelpTakesThePlaceOfTheSettings) {
    settings_.view.help = true;
    const std::size_t alone = boxes({1280, 720}, {}).size();
    settings_.view.controls = true;
    EXPECT_EQ(boxes({1280, 720}, {}).size(), alone);
}

TEST_F(PanelBoxes, NameNoNodeWhileTheHandHoldsTheCloth) {
    FrameView view = simulation_.view();
    view.settings = &settings_;
    int drawn[2] = {0, 0};  // vertices, of which a name takes some
    for (const bool held : {false, true}) {
        view.held = held;
        panels_.hover_y = 150;
        for (panels_.hover_x = 0; panels_.hover_x < 640; panels_.hover_x += 20) {
            panels_.build(view, Camera(settings_.view), {}, {}, 640, 480);
            drawn[held] += ImGui::GetDrawData()->TotalVtxCount;
        }
    }
    EXPECT_GT(drawn[false], drawn[true]);
}

TEST_F(PanelBoxes, AlwaysHaveTheTour) {
    settings_.view.panel = PanelSize::Full;
    settings_.view.bounds = false;
    give_hint();
    for (const PictureSize& size : picture_shapes) {
        for (const double scale : {1.0, 4.0}) {
            for (const bool on : {false, true}) {
                settings_.view.text_scale = scale;
                settings_.view.controls = settings_.view.plots = on;
                // It is the last, whatever goes
                const PanelBox tour = boxes(size, {}).back();
                EXPECT_GT(tour.right - tour.left, 200) << size.width << ", text " << scale << ", " << on;
                EXPECT_GT(tour.top, static_cast<float>(size.height) / 4) << size.width << ", " << scale << ", " << on;
            }
        }
    }
}

TEST_F(PanelBoxes, AreTwiceAsLargeOnADisplayOfTwiceAsManyPixels) {
    settings_.view.controls = settings_.view.plots = true;
    const std::vector<PanelBox> usual = boxes({1280, 720}, {});
    panels_.display_scale = 2;
    const std::vector<PanelBox>& fine = boxes({2560, 1440}, {});
    ASSERT_EQ(fine.size(), usual.size());
    for (std::size_t i = 0; i < fine.size(); ++i) {
        EXPECT_NEAR((fine[i].right - fine[i].left) / (usual[i].right - usual[i].left), 2, 0.2) << i;
        EXPECT_NEAR((fine[i].bottom - fine[i].top) / (usual[i].bottom - usual[i].top), 2, 0.2) << i;
    }
}

TEST_F(PanelBoxes, AreNotSmallerOnADisplayOfMorePixels) {
    for (const PictureSize& size : {PictureSize{1280, 720}, PictureSize{1920, 1080}}) {
        float before = 0;
        for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
            panels_.display_scale = scale;
            const float width = boxes(size, {}).front().right;
            EXPECT_GE(width, before) << size.width << ", display scale " << scale;
            before = width;
        }
    }
}

/// Rows, seen from the panel's height.
TEST_F(PanelBoxes, HaveRowsForTheBalanceThatIsAskedFor) {
    settings_.view.bounds = settings_.solver.ledger = false;
    settings_.view.panel = PanelSize::Compact;
    const auto height = [&] { return boxes({1280, 720}, {}).front().bottom; };
    const float without = height();
    settings_.solver.ledger = true;
    const float row = 15;
    EXPECT_GT(height(), without + 9 * row);
}

}  // namespace
}  // namespace drape
