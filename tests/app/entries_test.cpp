#include "drape/render/entries.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "../../src/app/keys.h"
#include "drape/scene/scene.h"
#include "drape/session/start.h"
#include "drape/session/tour.h"
#include "drape/sim/command.h"
#include "drape/sim/simulation.h"
#include "support/process.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

TEST(Entries, ParseAsCommandsThatReadBackAlikeAndHaveKeysOfTheirOwn) {
    std::set<std::string> keys;
    for (const Entry& entry : make_entries(scene_names())) {
        const std::string& command = entry.command;
        if (!command.empty()) {
            EXPECT_EQ(command_text(parse_command(command)), command) << entry.text;
        }
        for (const std::string& key : entry.keys) EXPECT_TRUE(keys.insert(key).second) << key;
    }
}

std::string mark_text(const Entry& entry, const Simulation& simulation) {
    return std::string(MenuMark(entry).text(simulation.settings(), simulation.scene(), simulation.paused()));
}

TEST(MenuMark, IsOnEveryEntryThatNamesThePresentValue) {
    const std::vector<Entry> entries = make_entries(scene_names());
    int values = 0;
    for (const Entry& entry : entries) {
        // What an entry sets by itself is no choice among others
        if (!entry.command.starts_with("set ") || entry.menu.empty() || entry.manner != Manner::Once) continue;
        ++values;
        Simulation simulation("drop", load_scene("drop"));
        simulation.apply(parse_command(entry.command));
        for (const Entry& other : entries) {
            if (!other.command.starts_with(entry.command.substr(0, entry.command.find('=') + 1))) continue;
            const bool same = other.command == entry.command && other.menu == entry.menu;
            EXPECT_EQ(mark_text(other, simulation), same ? "now" : "") << other.command << " after " << entry.command;
        }
    }
    EXPECT_GT(values, 30);
}

TEST(MenuMark, SaysWhetherAFlagIsOnAndWhatScene) {
    Simulation simulation("drop", load_scene("drop"));
    const auto text_of = [&](const char* command) { return mark_text({"View", {}, "", command}, simulation); };
    EXPECT_EQ(text_of("next wind.on"), "off");
    simulation.apply(parse_command("next wind.on"));
    EXPECT_EQ(text_of("next wind.on"), "on");
    EXPECT_EQ(text_of("next solver.integrator"), "");
    EXPECT_EQ(text_of("scene drop"), "now");
    EXPECT_EQ(text_of("scene curtain"), "");
    EXPECT_EQ(text_of("pause"), "");
    simulation.apply(parse_command("set solver.dt=3e-4"));
    EXPECT_EQ(text_of("add solver.dt 1e-04"), "3e-04 s") << "no value of the list is the present one";
}

TEST(Entries, ALetterIsItsKeyInEitherCaseUnlessShiftHasItsOwn) {
    const std::vector<Entry> entries = make_entries(scene_names());
    const auto command_of = [&](unsigned char code, bool shift, bool control = false) {
        const Entry* entry = find_entry(entries, character_key(code, shift, control));
        return entry == nullptr ? "" : entry->command + (entry->manner == Manner::OneFrame ? " frame" : "");
    };
    EXPECT_EQ(command_of('b', false), "next view.bounds");
    EXPECT_EQ(command_of('B', true), "next view.bounds");
    EXPECT_EQ(command_of('B', false), "next view.bounds");  // Caps Lock
    EXPECT_EQ(command_of('o', false), "step 1");
    EXPECT_EQ(command_of('O', false), "step 1");  // Caps Lock
    EXPECT_EQ(command_of('O', true), "step 1 frame");
    EXPECT_EQ(command_of('?', true), "next view.help");
    EXPECT_EQ(command_of('[', false), "add view.level -1");
    EXPECT_EQ(command_of(' ', false), "pause");
    EXPECT_EQ(command_of(27, false), "quit");
    for (const bool shift : {false, true}) EXPECT_EQ(command_of('q', shift), "steer 0 -1 0");
    constexpr unsigned char control_q = 'Q' - 'A' + 1, control_i = '\t';
    EXPECT_EQ(command_of(control_q, false, true), "quit");
    EXPECT_EQ(command_of(control_q, true, true), "quit");  // Caps Lock
    EXPECT_EQ(character_key('Z' - 'A' + 1, true, true), "Ctrl+Shift+Z") << "which has an entry of its own";
    EXPECT_EQ(without_modifiers("Ctrl+Shift+Z"), "Z");
    EXPECT_EQ(without_modifiers("+"), "+");
    EXPECT_EQ(command_of(control_i, false, true), "");
    EXPECT_EQ(command_of(control_i, false), "next view.panel");
    EXPECT_EQ(command_of(27, false, true), "");
    EXPECT_EQ(command_of('#', false), "");
}

TEST(Entries, MakeMenusThatFitOnASmallScreen) {
    constexpr int screen = 600, row = 25;  // pixel, the latter in freeglut's menu
    std::map<std::string, std::set<std::string>> menus;
    for (const Entry& entry : make_entries(scene_names())) {
        menus[entry.menu].insert("entry " + entry.text);
        for (std::string menu = entry.menu; !menu.empty();) {
            const std::string name = menu;
            menu = name.find('/') == std::string::npos ? "" : name.substr(0, name.rfind('/'));
            menus[menu].insert("menu " + name);
        }
    }
    for (const auto& [name, items] : menus) EXPECT_LE(static_cast<int>(items.size()) * row, screen) << name;
}

TEST(Entries, OfTheBallHelpOnlyInScenesThatHaveOne) {
    const std::vector<Entry> entries = make_entries(scene_names());
    std::set<std::string> of_a_ball;
    for (const KeyHelp& line : help_lines(entries, true)) of_a_ball.insert(line.text);
    for (const KeyHelp& line : help_lines(entries, false)) of_a_ball.erase(line.text);
    for (const KeyHelp& line : help_lines(entries, true)) {
        const bool says_ball =
            line.text.find("ball") != std::string::npos || line.text.find("Ball") != std::string::npos;
        EXPECT_EQ(of_a_ball.contains(line.text), says_ball) << line.text;
    }
}

TEST(Entries, AreHintedAtWithoutTheBallWhereThereIsNone) {
    EXPECT_EQ(first_hints(false).size() + 1, first_hints(true).size());
    for (const KeyHelp& line : first_hints(false)) EXPECT_EQ(line.text.find(" ball"), std::string::npos) << line.text;
}

TEST(Entries, AreTheTableOfTheReadme) {
    const std::string readme = test::read_file(std::string(DRAPE_SOURCE_DIR) + "/README.md");
    std::string table;
    for (const KeyHelp& line : help_lines(make_entries(scene_names()), true)) {
        table += "| " + (line.is_heading() ? "**" + line.text + "** | |\n" : line.key + " | " + line.text + " |\n");
    }
    EXPECT_NE(readme.find(table), std::string::npos) << table;
}

TEST(Help, NeedsNoData) {
    const ScratchFolder folder;
    const std::string alone = folder.path() / "drape";
    std::filesystem::copy(std::string(DRAPE_PROGRAMS) + "/drape", alone);
    test::Process drape({alone, "--help"}, {{"DRAPE_DATA", ""}}, folder.path());
    EXPECT_EQ(drape.wait(60), 0) << drape.standard_error();
    EXPECT_NE(drape.standard_output().find("1-9"), std::string::npos);
}

TEST(Tour, IsThePageOfTheDocsWithSmallPictures) {
    const std::filesystem::path docs = std::filesystem::path(DRAPE_SOURCE_DIR) / "docs";
    EXPECT_EQ(test::read_file(docs / "tour.md"), tour_page()) << "drape-lab list tour > docs/tour.md";
    for (const TourStop& stop : tour_stops()) {
        EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::path(DRAPE_SOURCE_DIR) / stop.file)) << stop.file;
    }
    std::uintmax_t bytes = 0;
    std::size_t number = 0;
    for (const TourStop& stop : tour_stops()) {
        const std::string digits = std::to_string(++number);
        const auto picture = docs / "tour" / ("frame_" + std::string(4 - digits.size(), '0') + digits + ".png");
        const std::string scene = "iTXtScene" + std::string(5, '\0') + std::string(stop.scene);
        EXPECT_NE(test::read_file(picture).find(scene), std::string::npos) << picture << " is of another scene";
        bytes += test::read_file(picture).size();
    }
    EXPECT_LT(bytes, 4'300'000u);
}

TEST(Tour, SaysAtItsLastStopThatTheFirstFollows) {
    EXPECT_TRUE(tour_hint(0).back().text.starts_with("Next stop"));
    EXPECT_TRUE(tour_hint(tour_stops().size() - 1).back().text.starts_with("First stop"));
}

TEST(Tour, ItsSessionIsReplayedToItsEnd) {
    Session session = make_session(make_start({.replay = DRAPE_SOURCE_DIR "/docs/tour/session.txt"}));
    session.run_replay();
    EXPECT_EQ(session.replay_notice(), "") << "every command is carried out";
    EXPECT_EQ(session.simulation().settings().cloths[0].pinned, Pins{}) << "G was pressed last";
    EXPECT_GT(session.simulation().report().contacts, 0) << "the cloth has fallen on the ball";
}

}  // namespace
}  // namespace drape
