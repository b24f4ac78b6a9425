// Keys and menu, pressed as a user presses them.

#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "../../src/app/keys.h"
#include "app/window_fixture.h"
#include "drape/base/stopwatch.h"
#include "drape/render/entries.h"
#include "drape/scene/scene.h"
#include "drape/session/comparison.h"
#include "drape/session/tour.h"

namespace drape {
namespace {

using test::eventually;
using test::WindowTest;
using testing::ElementsAre;

// An entry's key as xdotool calls it.
std::string symbol_of(const std::string& key) {
    static const std::map<std::string, std::string> names{
        {"Space", "space"},   {".", "period"},       {",", "comma"},      {"<", "less"},  {"?", "question"},
        {"[", "bracketleft"}, {"]", "bracketright"}, {"-", "minus"},      {"=", "equal"}, {"+", "plus"},
        {"Esc", "Escape"},    {"PageUp", "Prior"},   {"PageDown", "Next"}};
    if (const auto found = names.find(key); found != names.end()) return found->second;
    if (key.starts_with("Shift+")) return "shift+" + symbol_of(key.substr(6));
    if (key.starts_with("Ctrl+")) return "ctrl+" + symbol_of(key.substr(5));
    return key.size() == 1 && std::isupper(static_cast<unsigned char>(key[0])) != 0
               ? std::string(1, static_cast<char>(std::tolower(key[0])))
               : key;
}

TEST_F(WindowTest, EveryKeyGivesTheCommandOfItsEntry) {
    start({"hang"});
    for (const auto& [key, speed] : {std::pair{"minus", "0.5"}, {"equal", "1"}, {"minus", "0.5"}, {"equal", "1"}}) {
        const std::size_t before = commands().size();
        desktop_.key(key);
        EXPECT_TRUE(recorded(std::string("set view.speed=") + speed, before)) << "slower and faster";
    }
    std::string last = "-";
    for (const Entry& entry : make_entries(scene_names())) {
        if (entry.command == "quit" || entry.command.empty()) continue;
        for (const std::string& key : entry.keys) {
            if (without_modifiers(key) == last) {
                // A key of its own between two of the same: else the second could pass for a repeat of the first
                const std::size_t with_shift = commands().size();
                desktop_.key("c");
                EXPECT_TRUE(recorded("next view.contacts", with_shift));
            }
            last = without_modifiers(key);
            const std::size_t before = commands().size();
            desktop_.key(symbol_of(key));
            const std::size_t name_end = entry.command.find_first_of(entry.command.starts_with("set") ? "=" : " ");
            const std::string expected =
                entry.manner == Manner::Once ? entry.command : entry.command.substr(0, name_end);
            EXPECT_TRUE(recorded(expected, before)) << key << ": " << expected;
            // Two opposite keys that are seen at once steer nowhere
            if (entry.manner == Manner::WhileHeld) {
                EXPECT_TRUE(recorded("steer 0 0 0", before)) << key;
            }
        }
    }
    EXPECT_TRUE(std::filesystem::exists(file("drape-0001.png")));
    quit();
}

TEST_F(WindowTest, TimeGoesBackAndFromThereOn) {
    start({"hang"});
    desktop_.key("c");
    ASSERT_TRUE(recorded("next view.contacts"));
    ASSERT_TRUE(test::eventually([&] { return last_step() > 0; })) << "a hash tells of steps to go back";
    desktop_.key("space");
    ASSERT_TRUE(recorded("pause"));
    desktop_.key("comma");
    desktop_.key("less");
    desktop_.key("v");
    ASSERT_TRUE(recorded("next wind.on"));
    EXPECT_FALSE(recorded_now("pause")) << "it came after";
    quit();
}

TEST_F(WindowTest, TheTourGoesForwardAndBackAndEscapeLeavesIt) {
    start({"--tour"});
    const auto stops = tour_stops();
    // The last stop comes before the first
    const auto goes_to = [&](const char* key, std::size_t stop) {
        const std::size_t before = commands().size();
        desktop_.key(key);
        EXPECT_TRUE(recorded("scene " + std::string(stops[stop].scene), before)) << key << " to stop " << stop + 1;
        for (const std::string& change : split_assignments(stops[stop].changes)) {
            EXPECT_TRUE(recorded("set " + change, before)) << key << " to stop " << stop + 1;
        }
    };
    goes_to("F1", 1);
    goes_to("F1", 2);
    desktop_.act({"key", "--repeat", "6", "equal"});
    EXPECT_TRUE(eventually([this] { return drape_->standard_error().find("Diverged") != std::string::npos; }));
    EXPECT_FALSE(std::filesystem::exists(file("unstable.toml"))) << "the window writes no file unasked";
    goes_to("F2", 1);
    goes_to("F2", 0);
    goes_to("F2", stops.size() - 1);
    desktop_.key("Escape");
    desktop_.key("space");
    ASSERT_TRUE(recorded("pause")) << "the program runs on";
    const std::size_t paused = commands().size();
    goes_to("F1", stops.size() - 1);
    EXPECT_TRUE(recorded("pause", paused)) << "and so does the tour, from where it was left";
    desktop_.key("3");
    ASSERT_TRUE(recorded("scene " + scene_names()[2])) << "another scene is none of the tour";
    desktop_.act({"key", "--repeat", "2", "Escape"});
    EXPECT_EQ(drape_->wait(60), 0) << drape_->standard_error();
}

TEST_F(WindowTest, WhoLeavesTheTourLeavesItsComparison) {
    start({"--tour"});
    desktop_.key("F1");
    ASSERT_TRUE(recorded("compare cloth.shear.stiffness=200"));
    const std::size_t compared = commands().size();
    desktop_.key("Escape");
    EXPECT_TRUE(recorded("compare none", compared));
    quit();
}

TEST_F(WindowTest, AReloadedSceneIsAsTheWindowFirstShowedIt) {
    start({"hang", "--set", "solver.dt=3e-4", "--versus", "contact.friction=0.7"});
    const auto reload = [this] {
        std::size_t before = commands().size();
        desktop_.key("i");
        EXPECT_TRUE(recorded("next solver.integrator", before));
        before = commands().size();
        desktop_.key("ctrl+r");
        EXPECT_TRUE(recorded("set ", before));
        const std::vector<std::string> all = commands();
        return std::vector(all.begin() + static_cast<std::ptrdiff_t>(before), all.end());
    };
    EXPECT_THAT(reload(), ElementsAre("scene hang", "compare contact.friction=0.7", "set solver.dt=3e-4"));
    desktop_.act({"key", "--repeat", "4", "F1"});
    ASSERT_TRUE(recorded("set view.target=0.12"));
    const std::vector<std::string> stop = reload();
    EXPECT_EQ(stop[1], "scene " + std::string(tour_stops()[3].scene));
    EXPECT_EQ(stop[2], "set contact.leaf_cells=2") << "the stop of the tour, with its changes";
    quit();
}

TEST_F(WindowTest, AChangeOfASettingIsTakenBackAndMadeAgain) {
    start({"hang"});
    // A key of its own between two of the same
    const auto gives = [this](const char* key, const char* command) {
        for (const auto& [pressed, expected] : {std::pair{key, command}, {"p", "pause"}}) {
            const std::size_t before = commands().size();
            desktop_.key(pressed);
            EXPECT_TRUE(recorded(expected, before)) << key;
        }
    };
    gives("i", "next solver.integrator");
    gives("t", "next contact.volume");
    gives("ctrl+z", "set contact.volume=sphere");
    gives("ctrl+z", "set solver.integrator=symplectic_euler");
    gives("ctrl+y", "set solver.integrator=velocity_verlet");
    gives("ctrl+shift+z", "set contact.volume=aabb");
    gives("ctrl+z", "set contact.volume=sphere");
    gives("2", "scene ");
    const std::size_t loaded = commands().size();
    desktop_.act({"key", "ctrl+z", "ctrl+y", "p"});
    EXPECT_TRUE(recorded("pause", loaded));
    EXPECT_EQ(commands().size(), loaded + 1) << "another scene has changes of its own";
    quit();
}

TEST_F(WindowTest, ARunThatAChangeEndedGoesOnFromThereWhenItIsTakenBack) {
    start({"hang"});
    desktop_.key("slash");
    desktop_.act({"type", "20 ms"});
    desktop_.key("Return");
    ASSERT_TRUE(eventually([this] { return drape_->standard_error().find("Diverged") != std::string::npos; }));
    const long long changed = numbered_lines().back().first;
    desktop_.key("ctrl+z");
    ASSERT_TRUE(recorded(assignments_of(load_scene("hang"), "solver.dt").front().insert(0, "set ")));
    EXPECT_EQ(numbered_lines().back().first, changed);
    EXPECT_TRUE(eventually([&] { return last_step() > changed; })) << "it runs";
    EXPECT_EQ(drape_->standard_error().rfind("Diverged"), drape_->standard_error().find("Diverged"));
    quit();
}

TEST_F(WindowTest, AHeldKeySteersUntilItIsLetGo) {
    start({"original"});
    desktop_.act({"keydown", "Left"});
    ASSERT_TRUE(recorded("steer "));
    desktop_.hold("v", window_, 5);
    ASSERT_TRUE(recorded("next wind.on"));
    EXPECT_EQ(commands().size(), 2u) << "a key that repeats acts once";
    desktop_.act({"keyup", "Left"});
    ASSERT_TRUE(recorded("steer 0 0 0", 2));
    const auto steers_with = [this](const std::vector<std::string>& words) {
        const std::size_t before = commands().size();
        desktop_.act(words);
        EXPECT_TRUE(recorded("steer ", before));
        return before + 1;
    };
    const std::size_t shifted = steers_with({"keydown", "shift", "keydown", "w"});
    desktop_.act({"keyup", "shift", "keyup", "w"});
    EXPECT_TRUE(recorded("steer 0 0 0", shifted)) << "Shift goes first";
    const std::size_t controlled = steers_with({"keydown", "q", "keydown", "ctrl"});
    desktop_.act({"keyup", "q", "keyup", "ctrl"});
    EXPECT_TRUE(recorded("steer 0 0 0", controlled)) << "Control comes in between, and does not quit";
    const std::size_t lost = steers_with({"keydown", "d"});
    desktop_.take_keyboard_away();
    EXPECT_TRUE(recorded("steer 0 0 0", lost)) << "without the keyboard";
    desktop_.act({"keyup", "d", "windowfocus", window_});
    quit();
}

TEST_F(WindowTest, TheMenuChoosesUnderThePointerAndAnOpenOneDoesNoHarm) {
    start({"hang"});
    desktop_.choose_in_menu(100, 100, 3);
    EXPECT_TRUE(recorded("reset"));
    desktop_.choose_in_menu(100, 100, 1);
    EXPECT_TRUE(recorded("pause", 1));
    // While paused, too, and with a text that has changed meanwhile.
    desktop_.choose_in_menu(100, 100, 1);
    EXPECT_TRUE(recorded("pause", 2));
    // Texts change and scenes are loaded under an open menu
    desktop_.open_menu(100, 100);
    for (const auto& [key, command] : {std::pair{"v", "next wind.on"},
                                       {"b", "next view.bounds"},
                                       {"2", "scene "},
                                       {"F1", "scene "},
                                       {"3", "scene "}}) {
        const std::size_t before = commands().size();
        desktop_.key(key);
        EXPECT_TRUE(recorded(command, before)) << key;
    }
    const std::size_t before = commands().size();
    desktop_.move_to(120, 100 + 25 / 2);
    desktop_.click(1);
    EXPECT_TRUE(recorded("pause", before)) << "the first entry of the menu";
    EXPECT_TRUE(test::eventually([&] { return desktop_.visible_windows() == 1; }));
    quit();
}

// A notice is dark before a bright background, at the top in the middle, and stays for five seconds
TEST_F(WindowTest, ASceneTakesItsNoticesWithIt) {
    start({"hang"});
    const auto comes_to = [this](bool shown) {
        return eventually([&] { return (*desktop_.picture_of(window_).pixel(320, 10) < 100) == shown; });
    };
    EXPECT_TRUE(comes_to(false));
    // More than once, should the machine be slow
    EXPECT_TRUE(eventually([&] {
        desktop_.key("v");
        EXPECT_TRUE(comes_to(true));
        const Stopwatch watch;
        desktop_.key("ctrl+r");
        EXPECT_TRUE(comes_to(false));
        return watch.seconds() < 3;
    }));
    quit();
}

TEST_F(WindowTest, EscapeClosesWhatIsOpenBeforeItAsksAndQuits) {
    start({"hang", "--set", "view.controls=true", "view.help=true", "--versus", "contact.friction=0.7"});
    const std::size_t begun = commands().size();
    desktop_.open_menu(20, 100);
    desktop_.key("Escape");
    ASSERT_TRUE(test::eventually([&] { return desktop_.visible_windows() == 1; })) << "the menu stays";
    EXPECT_EQ(commands().size(), begun);
    desktop_.hold("Escape", window_, 5);
    ASSERT_TRUE(recorded("set view.help=false"));
    desktop_.key("c");
    ASSERT_TRUE(recorded("next view.contacts"));
    EXPECT_FALSE(recorded_now("set view.controls")) << "a key that is held closes one thing";
    desktop_.key("Escape");
    ASSERT_TRUE(recorded("set view.controls=false"));
    desktop_.key("Escape");
    ASSERT_TRUE(recorded("compare none"));
    desktop_.hold("Escape", window_, 5);
    desktop_.key("v");
    ASSERT_TRUE(recorded("next wind.on")) << "it has asked, and goes on";
    desktop_.key("Escape");
    EXPECT_EQ(drape_->wait(60), 0) << drape_->standard_error();
}

TEST_F(WindowTest, AKeyWithControlIsNoTextForTheSearch) {
    start({"hang"});
    for (const char* key : {"slash", "w", "ctrl+q"}) desktop_.key(key);
    EXPECT_EQ(drape_->wait(60), 0) << drape_->standard_error();
}

}  // namespace
}  // namespace drape
