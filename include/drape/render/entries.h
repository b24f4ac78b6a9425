#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drape/render/renderer.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/command.h"

namespace drape {

/// When an entry's command is given.
enum class Manner {
    Once,       ///< as the key goes down
    WhileHeld,  ///< a `steer` as the viewer sees it (right, up, ahead), until the key goes up
    Aimed,      ///< a `throw` from the viewer's side to where the view looks
    StepBack,   ///< one step back in time
    FrameBack,  ///< as many as one displayed frame takes
    OneFrame,   ///< a `step` of as many steps as one displayed frame takes
    SafeStep,   ///< a `reset` after a time step at 0.9 of the stability limit, where there is one
    Reload,     ///< the scene, or the stop of the tour, as it was first shown
    Slower,     ///< half the speed of time
    Faster,     ///< twice
    NextStop,   ///< of the tour: its scene and what it changes in it
    StopBefore,
    Compare,  ///< loads a scene and compares it
    Search,   ///< the drawn menu with its search field
    Fullscreen,
    Undo,  ///< of the last change of a setting
    Redo,
    SaveRecording,
    ReplayRun,   ///< from its start
    ReplayFile,  ///< a recording, which its text names
};

/// One thing that the user can do: from these, keys, menu, help panel and the README's table are made.
struct Entry {
    std::string menu;               ///< the submenu it is in, as "View/Colour by"; empty for the menu itself
    std::vector<std::string> keys;  ///< "P", "Space", "F12", "Shift+O", "Ctrl+Q": letters without Shift fit either case
    std::string text;               ///< as in the menu
    std::string command;            ///< in text form; empty: the window does it by itself
    Manner manner = Manner::Once;
    std::string help = {};   ///< of its line in the help, which it shares with the entries before it that have the same
    std::string group = {};  ///< of that line; empty: what the menu's path begins with, or "General"
    std::string change = {};  ///< of `Manner::Compare`: in what the scene is changed, "name=value,name=value"
    std::string versus = {};  ///< likewise: what it is then compared with, as `command::Compare` has it
};

/// Everything that keys and menu can do, in the order of the menu. Scenes are called by their titles.
/// @param scenes that are shipped, the first nine of them on the keys 1-9
std::vector<Entry> make_entries(const std::vector<std::string>& scenes);

/// The entry of a key; null if it has none. A key with Shift that has none of its own is the key without.
const Entry* find_entry(const std::vector<Entry>& entries, std::string_view key);

/// What follows an entry's text in the menu: whether what its command switches is on, or the value that it sets the
/// present one. The command is read once.
class MenuMark {
public:
    MenuMark() = default;

    /// @throws InputError if its command is none, or has a setting that is none
    explicit MenuMark(const Entry& entry);

    /// "on", "off", "paused", "now"; of what is added to, its present value; empty for what is none of these.
    /// @param scene its name or path
    [[nodiscard]] std::string text(const Settings& settings, std::string_view scene, bool paused) const;

private:
    Command command_ = command::Quit{};
    const Setting* setting_ = nullptr;   ///< that it names, if any
    std::optional<SettingValue> value_;  ///< that it sets it to
};

/// A key in words where it is a sign that a list of keys has too: "comma".
std::string key_name(std::string_view key);

/// "Space, P"; "equals, plus".
std::string key_text(const Entry& entry);

/// What a newcomer may try first, in a scene with a ball or in one without.
std::vector<KeyHelp> first_hints(bool has_ball);

/// What the hint panel says at a stop of the tour, counted from 0: what to see, what to try, what to read.
std::vector<KeyHelp> tour_hint(std::size_t stop);

/// The lines of the help by groups, each after its heading: the mouse's, then one for each entry with a key; the scenes
/// share one.
/// @param has_ball whether the scene has one: in others its entries mean nothing
std::vector<KeyHelp> help_lines(const std::vector<Entry>& entries, bool has_ball);

}  // namespace drape
