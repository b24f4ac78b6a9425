#pragma once

#include <random>
#include <string>

namespace drape::window_fuzz {

/// Random things that a user may do to a window of 640 x 480 at the upper left of the screen, in xdotool's language.
class EventSource {
public:
    explicit EventSource(unsigned long seed) : random_(seed) {}

    /// One of them, in a few lines. None quits by key; the menu may.
    std::string event(const std::string& window);

    /// The pointer on a menu that is open at a place: over its entries and those of its submenus, and a click.
    std::string menu_walk(int x, int y);

    /// Lets go of every key and button, shows the window at its size, and leaves menus, lists and fields.
    static std::string all_quiet(const std::string& window);

    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }

private:
    std::string anywhere();
    std::string on_the_panel();
    std::string key();
    std::string drag();
    std::string drag_on_the_panel();
    std::string typed_value();
    std::string size_or_visibility(const std::string& window);

    std::mt19937_64 random_;
};

}  // namespace drape::window_fuzz
