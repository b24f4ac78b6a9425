#include "events.h"

#include <iterator>

namespace drape::window_fuzz {

namespace {

/// Keys that `drape` knows and some that it does not; none that quits.
constexpr const char* keys[] = {"space",   "p",        "o",      "period", "shift+o", "r",           "shift+r",
                                "1",       "2",        "3",      "4",      "5",       "6",           "7",
                                "8",       "9",        "i",      "t",      "y",       "u",           "j",
                                "b",       "c",        "l",      "n",      "Tab",     "m",           "k",
                                "shift+k", "f",        "Left",   "a",      "Right",   "d",           "Up",
                                "w",       "Down",     "s",      "Prior",  "e",       "Next",        "shift+q",
                                "x",       "z",        "g",      "minus",  "equal",   "plus",        "v",
                                "h",       "F1",       "F2",     "F5",     "F12",     "bracketleft", "bracketright",
                                "comma",   "question", "ctrl+a", "alt+b",  "Return",  "BackSpace"};

/// What may be typed into a field.
constexpr const char* typed[] = {"0", "1", "2", "5", "9", "period", "minus", "e", "x", "BackSpace"};

constexpr const char* modifiers[] = {"", "", "shift", "ctrl"};

// A word of xdotool's with a number, as a line
std::string with(const char* word, int number) { return std::string(word) + " " + std::to_string(number) + "\n"; }

std::string pointer_to(const std::string& place) { return "mousemove " + place + "\n"; }

}  // namespace

// A little beside the window, too
std::string EventSource::anywhere() { return std::to_string(below(660)) + " " + std::to_string(below(500)); }

std::string EventSource::on_the_panel() { return std::to_string(330 + below(300)) + " " + std::to_string(below(480)); }

std::string EventSource::key() { return keys[below(std::size(keys))]; }

std::string EventSource::drag() {
    const std::string held = modifiers[below(std::size(modifiers))];
    const int button = 1 + below(2);
    std::string lines = held.empty() ? "" : "keydown " + held + "\n";
    lines += pointer_to(anywhere()) + with("mousedown", button);
    for (int moves = below(4); moves >= 0; --moves) lines += pointer_to(anywhere());
    lines += with("mouseup", button);
    return held.empty() ? lines : lines + "keyup " + held + "\n";
}

std::string EventSource::drag_on_the_panel() {
    std::string lines = pointer_to(on_the_panel()) + with("mousedown", 1);
    for (int moves = below(4); moves >= 0; --moves) lines += pointer_to(on_the_panel());
    return lines + with("mouseup", 1);
}

std::string EventSource::typed_value() {
    std::string lines = "keydown ctrl\n" + pointer_to(on_the_panel()) + "click 1\nkeyup ctrl\n";
    for (int keys_left = below(6); keys_left >= 0; --keys_left) {
        lines += std::string("key --delay 0 ") + typed[below(std::size(typed))] + "\n";
    }
    return lines + (below(2) == 0 ? "key --delay 0 Return\n" : "");
}

std::string EventSource::size_or_visibility(const std::string& window) {
    if (below(4) == 0) return "windowunmap " + window + "\nwindowmap " + window + "\n";
    return "windowsize " + window + " " + std::to_string(1 + below(700)) + " " + std::to_string(1 + below(500)) + "\n";
}

std::string EventSource::event(const std::string& window) {
    const std::string drags = drag(), slides = drag_on_the_panel();
    const std::string events[] = {pointer_to(anywhere()),
                                  with("mousedown", 1 + below(3)),
                                  with("mouseup", 1 + below(3)),
                                  with("click", 4 + below(2)),
                                  with("click", 1 + below(3)),
                                  below(4) == 0 ? size_or_visibility(window) : pointer_to(on_the_panel()),
                                  drags,
                                  drags,
                                  slides,
                                  slides,
                                  typed_value(),
                                  pointer_to(on_the_panel()) + with("click", below(3) == 0 ? 5 : 1),
                                  "keydown " + key() + "\n",
                                  "keyup " + key() + "\n"};
    const auto chosen = static_cast<std::size_t>(below(20));
    return chosen < std::size(events) ? events[chosen] : "key --delay 0 " + key() + "\n";
}

std::string EventSource::menu_walk(int x, int y) {
    constexpr int width = 400, height = 600;  // [pixel] of a menu with a submenu
    std::string lines;
    for (int moves = 1 + below(4); moves >= 0; --moves) {
        lines += pointer_to(std::to_string(x + 5 + below(width)) + " " + std::to_string(y + 5 + below(height)));
    }
    return lines + "click 1\n";
}

std::string EventSource::all_quiet(const std::string& window) {
    std::string lines;
    for (const char* name : keys) lines += std::string("keyup --delay 0 ") + name + "\n";
    for (const char* name : typed) lines += std::string("keyup --delay 0 ") + name + "\n";
    for (int button = 1; button <= 3; ++button) lines += with("mouseup", button);
    lines += "windowmap " + window + "\nwindowsize " + window + " 640 480\n";
    // A click beside the window closes a menu, one beside the panel what is open there
    lines += pointer_to("1200 1000") + "click 1\nwindowfocus " + window + "\n" + pointer_to("20 470") + "click 1\n";
    return lines;
}

}  // namespace drape::window_fuzz
