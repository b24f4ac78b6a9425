#include "drape/render/entries.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "drape/scene/scene.h"
#include "drape/session/tour.h"

namespace drape {

namespace {

constexpr std::string_view with_shift = "Shift+";

// The values of a setting as entries without a key
void append_values(std::vector<Entry>& entries, const std::string& menu, const std::string& setting,
                   std::initializer_list<std::pair<const char*, const char*>> values) {
    for (const auto& [text, value] : values) entries.push_back({menu, {}, text, "set " + setting + "=" + value});
}

// An entry that goes to the next choice of a setting, and one for each choice
void append_choices(std::vector<Entry>& entries, const std::string& menu, const std::string& setting, const char* key,
                    const char* text, const char* group) {
    entries.push_back({menu, {key}, text, "next " + setting, Manner::Once, {}, group});
    for (const std::string& choice : find_setting(setting).choices)
        entries.push_back({menu, {}, choice, "set " + setting + "=" + choice});
}

// Of the entry's line in the help
std::string heading_of(const Entry& entry) {
    if (!entry.group.empty()) return entry.group;
    return entry.menu.empty() ? "General" : entry.menu.substr(0, entry.menu.find('/'));
}

// Its name where its file cannot be read, which its choice tells of
std::string title_of(const std::string& scene) {
    try {
        return load_scene(scene).title;
    } catch (const std::runtime_error&) {
        return scene;
    }
}

}  // namespace

MenuMark::MenuMark(const Entry& entry) {
    // What an entry sets by itself is no choice among others
    if (entry.manner != Manner::Once || (entry.menu.empty() && entry.command.starts_with("set "))) return;
    command_ = parse_command(entry.command);
    if (const auto* next = std::get_if<command::Next>(&command_)) setting_ = &find_setting(next->setting);
    if (const auto* add = std::get_if<command::Add>(&command_)) setting_ = &find_setting(add->setting);
    if (const auto* set = std::get_if<command::Set>(&command_)) {
        const std::string_view assignment = set->assignment;
        const std::size_t equals = assignment.find('=');
        setting_ = &find_setting(assignment.substr(0, equals));
        value_ = parse_value(*setting_, assignment.substr(equals + 1));
    }
}

std::string MenuMark::text(const Settings& settings, std::string_view scene, bool paused) const {
    const auto now = [](bool is_present) { return std::string(is_present ? "now" : ""); };
    if (std::holds_alternative<command::Pause>(command_)) return paused ? "paused" : "";
    if (const auto* load = std::get_if<command::LoadScene>(&command_)) return now(scene == load->name);
    if (setting_ == nullptr) return "";
    const SettingValue present = setting_->read(settings, 0);
    if (value_) return now(present == *value_);
    const bool adds = std::holds_alternative<command::Add>(command_);
    return adds || std::holds_alternative<bool>(present) ? shown_value(*setting_, present) : "";
}

std::vector<Entry> make_entries(const std::vector<std::string>& scenes) {
    std::vector<Entry> entries{
        {"", {"Space", "P"}, "Pause / Resume", "pause", Manner::Once, {}, "Time"},
        {"Time", {"O", "."}, "Single step", "step 1"},
        {"Time", {"Shift+O"}, "Single frame of 1/60 s", "step 1", Manner::OneFrame},
        {"Time", {","}, "One step back", "", Manner::StepBack, "One step back, 1/60 s back"},
        {"Time", {"<"}, "1/60 s back", "", Manner::FrameBack, "One step back, 1/60 s back"},
        {"Time", {}, "Replay this run from its start", "", Manner::ReplayRun},
        {"", {"R"}, "Reset", "reset", Manner::Once, "Reset; changed settings stay", "Time"},
        {"", {"Shift+R"}, "Reset with a stable time step", "reset", Manner::SafeStep, {}, "Time"},
        {"", {"Ctrl+R"}, "Reload the scene", "", Manner::Reload, "Reload the scene: its settings, its view", "Time"},
    };
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        std::vector<std::string> keys;
        if (s < 9) keys.push_back(std::to_string(s + 1));
        const bool fails = scenes[s].starts_with("fails_");
        entries.push_back({fails ? "Failures" : "Scene", keys, title_of(scenes[s]), "scene " + scenes[s], Manner::Once,
                           "Scenes, as shipped", "Scenes and tour"});
    }
    append_choices(entries, "Integrator", "solver.integrator", "I", "Next integrator", "Methods");
    entries.push_back({"Integrator", {}, "Hessian clamped or exact", "next solver.hessian"});
    entries.push_back({"Integrator", {}, "Five iterations more", "add solver.iterations 5"});
    entries.push_back({"Integrator", {}, "Five iterations fewer", "add solver.iterations -5"});
    for (const char* milliseconds : {"0.05", "0.1", "0.2", "0.5", "1", "2", "5", "10", "20"}) {
        const std::string text(milliseconds);
        entries.push_back({"Time step", {}, text + " ms", "set solver.dt=" + text + "e-3"});
    }
    entries.push_back({"Time step", {}, "0.1 ms longer", "add solver.dt 1e-04"});
    entries.push_back({"Time step", {}, "0.1 ms shorter", "add solver.dt -1e-04"});
    append_values(entries, "Time step", "solver.on_unstable",
                  {{"Above the stability limit: warn", "warn"},
                   {"Above the stability limit: substep", "substep"},
                   {"Above the stability limit: quit", "stop"}});
    append_choices(entries, "Hierarchy/Bounding volume", "contact.volume", "T", "Next bounding volume", "Methods");
    append_choices(entries, "Hierarchy/Sphere fit", "contact.sphere_fit", "Y", "Next sphere fit", "Methods");
    append_choices(entries, "Hierarchy/BVH update policy", "contact.update", "U", "Next BVH update policy", "Methods");
    append_choices(entries, "View/Colour by", "view.colour", "J", "Colour the cloth by the next quantity", "View");
    const auto compare = [&](const char* text, const char* scene, const char* change, const char* versus) {
        entries.push_back({"Compare",
                           {},
                           std::string(text) + ": " + title_of(scene),
                           std::string("scene ") + scene,
                           Manner::Compare,
                           {},
                           {},
                           change,
                           versus});
    };
    const char* fast =
        "contact.continuous=false,solver.dt=5e-3,solver.integrator=backward_euler,ball.velocity=0,1,60,view.speed=0.05";
    compare("explicit_euler against backward_euler", "fails_explicit_euler", "", "solver.integrator=backward_euler");
    compare("sphere against aabb", "drop", "contact.volume=sphere", "contact.volume=aabb");
    compare("Discrete against continuous detection", "bullet", fast, "contact.continuous=true");
    compare("Penalty against hybrid response", "drop", "contact.response=penalty", "contact.response=hybrid");
    compare("15 x 15 against 29 x 29 particles", "original", "cloth.particles=15,15", "cloth.particles=29,29");
    entries.push_back({"Compare", {}, "End of the comparison", "compare none"});
    append_values(
        entries, "Hierarchy/Leaf size", "contact.leaf_cells",
        {{"Auto", "0"}, {"2 x 2 cells", "2"}, {"4 x 4 cells", "4"}, {"7 x 7 cells", "7"}, {"15 x 15 cells", "15"}});
    append_values(entries, "Hierarchy/Search depth", "contact.search_level",
                  {{"Unlimited", "30"}, {"To level 4", "4"}, {"To level 3", "3"}, {"To level 2", "2"}});
    append_values(entries, "Time/Sleep", "solver.sleep_speed", {{"At rest", "2e-04"}, {"Never", "0"}});
    const char *across = "Ball left, right", *along = "Ball away from you, towards you";
    const char *panels = "Panels", *tour = "Tour: next, previous stop", *scenes_and_tour = "Scenes and tour";
    const std::vector<Entry> rest{
        {"View", {"B"}, "Bounding volumes", "next view.bounds"},
        {"View", {"["}, "Level -", "add view.level -1", Manner::Once, "Coarser, finer level of bounding volumes"},
        {"View", {"]"}, "Level +", "add view.level 1", Manner::Once, "Coarser, finer level of bounding volumes"},
        {"View", {"C"}, "Contacts", "next view.contacts"},
        {"View", {"L"}, "Wireframe", "next view.wireframe"},
        {"View", {"N"}, "Particles and springs", "next view.particles"},
        {"View", {}, "Weave of the cloth", "next view.weave"},
        {"View", {}, "Smooth outlines", "next view.smooth"},
        {"View", {}, "Grid on the ground", "next view.grid"},
        {"View", {"Tab"}, "Stats panel: compact, full, off", "next view.panel", Manner::Once, {}, panels},
        {"View", {"M"}, "Settings panel", "next view.controls", Manner::Once, {}, panels},
        {"View", {"Shift+K"}, "Plots of the last seconds", "next view.plots", Manner::Once, {}, panels},
        {"View", {"K"}, "Energy balance", "next solver.ledger", Manner::Once, {}, panels},
        {"View", {"F11"}, "Fullscreen", "", Manner::Fullscreen},
        {"View", {"F"}, "Frame the scene with the camera", "frame"},
        {"View", {"Shift+F"}, "First view of the scene", "home"},
        {"Ball", {"Left", "A"}, "Ball to the left", "steer -1 0 0", Manner::WhileHeld, across},
        {"Ball", {"Right", "D"}, "Ball to the right", "steer 1 0 0", Manner::WhileHeld, across},
        {"Ball", {"Up", "W"}, "Ball away from you", "steer 0 0 1", Manner::WhileHeld, along},
        {"Ball", {"Down", "S"}, "Ball towards you", "steer 0 0 -1", Manner::WhileHeld, along},
        {"Ball", {"PageUp", "E"}, "Ball up", "steer 0 1 0", Manner::WhileHeld, "Ball up, down"},
        {"Ball", {"PageDown", "Q"}, "Ball down", "steer 0 -1 0", Manner::WhileHeld, "Ball up, down"},
        {"Ball", {"X"}, "Throw the ball where you look", "throw 0 0 0 0 0 0", Manner::Aimed},
        {"Ball", {"Z"}, "Let the ball fall", "fall"},
        {"", {"G"}, "Remove all pins", "set cloth.pinned=none", Manner::Once, {}, "Cloth and wind"},
        {"Time", {"-"}, "Slower", "set view.speed=0.5", Manner::Slower, "Slower, faster"},
        {"Time", {"=", "+"}, "Faster", "set view.speed=2", Manner::Faster, "Slower, faster"},
        {"", {"Ctrl+Z"}, "Undo the last change of a setting", "", Manner::Undo},
        {"", {"Ctrl+Y", "Ctrl+Shift+Z"}, "Redo it", "", Manner::Redo},
        {"", {"V"}, "Wind", "next wind.on", Manner::Once, {}, "Cloth and wind"},
        {"", {"Ctrl+S"}, "Save recording", "", Manner::SaveRecording, "Save recording; / replays it"},
        {"", {"F12"}, "Save screenshot", "picture"},
        {"", {"Shift+F12"}, "Record video: start, end", "video"},
        {"Tour", {"F1"}, "Tour: next stop", "", Manner::NextStop, tour, scenes_and_tour},
        {"Tour", {"F2"}, "Tour: previous stop", "", Manner::StopBefore, tour, scenes_and_tour},
        {"", {"/"}, "Search menu, settings and scenes", "", Manner::Search, {}, panels},
        {"", {"H", "?"}, "Help", "next view.help", Manner::Once, {}, panels},
        {"", {"Ctrl+Q", "Esc"}, "Quit", "quit", Manner::Once, "Quit; Esc closes what is open first, and asks"},
    };
    entries.insert(entries.end(), rest.begin(), rest.end());
    return entries;
}

const Entry* find_entry(const std::vector<Entry>& entries, std::string_view key) {
    const auto found = std::ranges::find_if(
        entries, [&](const Entry& entry) { return std::ranges::find(entry.keys, key) != entry.keys.end(); });
    if (found != entries.end()) return &*found;
    const std::size_t shift = key.find(with_shift);
    return shift == key.npos ? nullptr : find_entry(entries, std::string(key).erase(shift, with_shift.size()));
}

std::vector<KeyHelp> first_hints(bool has_ball) {
    std::vector<KeyHelp> hints{
        {"Drag", has_ball ? "Pull the cloth or a ball that can move; beside them, orbit the view"
                          : "Pull the cloth; beside it, orbit the view"},
        {"Right button", "Menu: scenes, integrators, bounding volumes"},
    };
    if (has_ball) hints.push_back({"Arrow keys", "Move the ball; E and Q up and down"});
    hints.push_back({"Space", "Pause / Resume"});
    hints.push_back({"B", has_ball ? "How the tree of bounding volumes saves tests" : "Bounding volumes of the cloth"});
    hints.push_back({"H", "All keys"});
    hints.push_back({"F1", "A tour of " + std::to_string(tour_stops().size()) + " stops"});
    return hints;
}

std::vector<KeyHelp> tour_hint(std::size_t stop) {
    const auto stops = tour_stops();
    const TourStop& now = stops[stop];
    const bool is_last = stop + 1 == stops.size();
    return {{std::to_string(stop + 1) + " of " + std::to_string(stops.size()), std::string(now.title)},
            {"See", std::string(now.look)},
            {"Try", std::string(now.try_it)},
            {"Source", std::string(now.file)},
            {"F1, F2, Esc",
             is_last ? "First stop, previous stop, end of the tour" : "Next stop, previous stop, end of the tour"}};
}

std::string key_name(std::string_view key) {
    constexpr std::array<std::pair<std::string_view, const char*>, 5> names{
        {{",", "comma"}, {".", "period"}, {"-", "minus"}, {"=", "equals"}, {"+", "plus"}}};
    const auto named = std::ranges::find(names, key, [](const auto& name) { return name.first; });
    return named == names.end() ? std::string(key) : named->second;
}

std::string key_text(const Entry& entry) {
    std::string text;
    for (const std::string& key : entry.keys) text += (text.empty() ? "" : ", ") + key_name(key);
    return text;
}

std::vector<KeyHelp> help_lines(const std::vector<Entry>& entries, bool has_ball) {
    std::vector<std::vector<KeyHelp>> groups{
        {{"", "Mouse"},
         {"Left drag", has_ball ? "Orbit the view; on the cloth or a ball that can move: pull it"
                                : "Orbit the view; on the cloth: pull it"},
         {"Middle or Shift+left drag", "Pan the view"},
         {"Ctrl+click", "Pin or free a particle"},
         {"Wheel", "Zoom"},
         {"Right button", "Menu"}}};
    for (const Entry& entry : entries) {
        if (entry.keys.empty() || (entry.menu == "Ball" && !has_ball)) continue;
        const std::string heading = heading_of(entry), text = entry.help.empty() ? entry.text : entry.help;
        const auto has_heading = [&](const std::vector<KeyHelp>& lines) { return lines.front().text == heading; };
        auto group = std::ranges::find_if(groups, has_heading);
        if (group == groups.end()) groups.push_back({{"", heading}}), group = groups.end() - 1;
        const bool is_scene = entry.menu == "Scene";
        if (group->back().text != text) {
            group->push_back({is_scene ? "1-9" : key_text(entry), text});
        } else if (!is_scene) {
            group->back().key += ", " + key_text(entry);
        }
    }
    std::vector<KeyHelp> lines;
    for (const std::vector<KeyHelp>& group : groups) lines.insert(lines.end(), group.begin(), group.end());
    return lines;
}

}  // namespace drape
