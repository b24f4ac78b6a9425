// The drawn menu, as a user searches it, without a window.

#include "render/menu_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "render/drawn_letters.h"
#include "render/overlay_panels.h"

namespace drape {
namespace {

using test::letters_within;

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

    /// @return the menu's box, which is the last
    PanelBox draw(int width, int height) {
        const Camera camera(simulation_.settings().view);
        for (int frame = 0; frame < 3; ++frame) panels_.build(simulation_.view(), camera, {}, {}, width, height);
        return panels_.boxes().back();
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
    EXPECT_EQ(chosen_for("kdop"), "set contact.volume=kdop6") << "where a word begins";
}

TEST_F(DrawnMenu, SaysThatNothingIsFound) {
    search("fullscreen");
    const PanelBox box = draw(1280, 720);
    EXPECT_EQ(letters_within({box.left + 9, box.top + 40, box.right - 9, box.bottom - 9}).whole, 12);
    panels_.type(enter);
    EXPECT_FALSE(panels_.wishes.entry);
    EXPECT_TRUE(panels_.menu_open());
}

TEST_F(DrawnMenu, ShowsTheWholeHelpOfEverySetting) {
    int shown = 0;
    for (const Setting& setting : setting_table()) {
        search(setting.full_name());
        const PanelBox box = draw(1280, 720);
        const float row = 16, below_the_list = box.bottom - 11 - 3.2f * row;
        const auto letters = letters_within({box.left + 9, below_the_list, box.right - 9, box.bottom - 2});
        const auto expected = setting.help.size() - static_cast<std::size_t>(std::ranges::count(setting.help, ' '));
        EXPECT_TRUE(letters.whole == 0 || letters.whole == static_cast<int>(expected)) << setting.full_name();
        EXPECT_EQ(letters.cut, 0) << setting.full_name();
        if (letters.whole > 0) ++shown;
    }
    EXPECT_GT(shown, 30) << "the others have no row in the panel, and are not found";
}

TEST_F(DrawnMenu, CutsNoRowAtAnyHeightHoweverItIsScrolled) {
    for (const int height : {480, 600, 700, 720, 733, 900}) {
        search("");
        for (int row = 0; row < 40; ++row) {
            const PanelBox box = draw(1280, height);
            const auto letters = letters_within({box.left + 9, box.top + 40, box.right - 9, box.bottom - 9});
            EXPECT_GT(letters.whole, 100);
            EXPECT_EQ(letters.cut, 0) << height << ", row " << row;
            panels_.type(next);
        }
    }
}

}  // namespace
}  // namespace drape
