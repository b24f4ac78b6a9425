// The drawn menu, as a user searches it, without a window.

#include "render/menu_panel.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "render/drawn_text.h"
#include "render/overlay_panels.h"

namespace drape {
namespace {

using testing::HasSubstr;

/// At the upper or lower edge of what they are in.
int letters_cut() {
    int count = 0;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4& part = command.ClipRect;
            for (unsigned k = command.IdxOffset; k + 2 < command.IdxOffset + command.ElemCount; k += 3) {
                const auto corner = [&](unsigned c) { return list.VtxBuffer[list.IdxBuffer[static_cast<int>(k + c)]]; };
                const ImDrawVert upper = corner(0), lower = corner(2);
                const bool is_letter = upper.uv.y != lower.uv.y && upper.pos.y < lower.pos.y;
                const bool is_there = lower.pos.y > part.y && upper.pos.y < part.w;
                if (is_letter && is_there && (upper.pos.y < part.y || lower.pos.y > part.w)) ++count;
            }
        }
    }
    return count;
}

class DrawnMenu : public testing::Test {
protected:
    static constexpr unsigned char next = 14, enter = 13;

    DrawnMenu() : simulation_("hang", load_scene("hang")), entries_(make_entries(scene_names())) {}

    void search(const std::string& query) {
        panels_.open_menu(entries_, simulation_.settings());
        for (const char c : query) panels_.type(static_cast<unsigned char>(c));
    }

    /// Its command, where it is an entry.
    std::string chosen_for(const std::string& query) {
        search(query);
        panels_.type(enter);
        const auto entry = std::exchange(panels_.wishes.entry, {});
        return entry ? entries_[*entry].command : "none";
    }

    /// What it says, its lines one after the other.
    std::string draw(int height = 720) {
        const Camera camera(simulation_.settings().view);
        for (int frame = 0; frame < 3; ++frame) panels_.build(simulation_.view(), camera, {}, {}, 1280, height);
        std::string text = test::drawn_text();
        std::ranges::replace(text, '\n', ' ');
        return text;
    }

    Simulation simulation_;
    std::vector<Entry> entries_;
    OverlayPanels panels_;
};

TEST_F(DrawnMenu, FindsWholeWordsOfATitleFirst) {
    EXPECT_EQ(chosen_for("table"), "scene table") << "not on_unstable, nor a stable step";
    EXPECT_EQ(chosen_for("camera"), "frame");
    EXPECT_EQ(chosen_for("f"), "frame") << "its key";
    EXPECT_EQ(chosen_for("wind"), "next wind.on");
    EXPECT_EQ(chosen_for("time step"), "none") << "the setting, not what resets";
    EXPECT_EQ(chosen_for("kdop"), "set contact.volume=kdop6") << "where a word begins";
}

TEST_F(DrawnMenu, HasWhatIsWithoutEffectLast) {
    search("stiffness");
    const std::string text = draw();
    EXPECT_LT(text.find("cloth.shear.stiffness"), text.find("contact.stiffness"));
    EXPECT_FALSE(why_without_effect(find_setting("contact.stiffness"), simulation_.settings(), 0).empty());
}

TEST_F(DrawnMenu, FindsASceneByItsCommandAndNotWhatReloads) {
    search("scene hang");
    panels_.type(enter);
    ASSERT_TRUE(panels_.wishes.entry);
    EXPECT_EQ(entries_[*panels_.wishes.entry].menu, "Scene");
}

TEST_F(DrawnMenu, SaysThatNothingIsFound) {
    search("full moon");
    EXPECT_THAT(draw(), HasSubstr("Nothing found"));
    panels_.type(enter);
    EXPECT_FALSE(panels_.wishes.entry);
    EXPECT_TRUE(panels_.menu_open());
}

TEST_F(DrawnMenu, ShowsTheWholeHelpOfASetting) {
    for (const char* name : {"solver.on_unstable", "solver.tolerance", "view.colour", "ground.height"}) {
        search(name);
        EXPECT_THAT(draw(), HasSubstr(find_setting(name).help));
        EXPECT_EQ(letters_cut(), 0) << name;
    }
}

TEST_F(DrawnMenu, CutsNoRowAtAnyHeightHoweverItIsScrolled) {
    for (const int height : {480, 600, 700, 720, 733, 900}) {
        search("");
        for (int row = 0; row < 40; ++row) {
            EXPECT_THAT(draw(height), HasSubstr("Search entries"));
            EXPECT_EQ(letters_cut(), 0) << height << ", row " << row;
            panels_.type(next);
        }
    }
}

}  // namespace
}  // namespace drape
