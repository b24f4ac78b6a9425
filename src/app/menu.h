#pragma once

#include <string>
#include <vector>

#include "drape/render/entries.h"
#include "drape/sim/simulation.h"

namespace drape {

/// The popup menu of the current window, under the right button. Its texts follow the simulation, but only while it is
/// closed: freeglut ends the program when a menu in use is changed.
class Menu {
public:
    /// @param display_scale as `Panels` has it; GLUT has one font that is larger than its usual one
    /// @param choose is called with the number of the chosen entry and `user`
    Menu(const std::vector<Entry>& entries, double display_scale, void (*choose)(int entry, void* user), void* user);

    /// GLUT's word on whether the menu is in use. One that closes is hidden: freeglut hides it at once, and shows it
    /// with its next work, so that one which opens and closes within a frame would stay on the screen.
    void set_open(bool open);
    [[nodiscard]] bool open() const { return open_; }

    /// Brings the texts up to date, unless the menu is open; then has it drawn again, for freeglut's first drawing of a
    /// menu that pops up comes too early for its size.
    void update(const Simulation& simulation);

private:
    struct Item {
        std::string text;  ///< without mark: "Wind  (V)"
        MenuMark mark;
        int menu;      ///< GLUT's number
        int position;  ///< in it, from 1
        std::string shown;
    };

    std::vector<Item> items_;
    int first_window_ = 0;  ///< of the menus' windows, which GLUT numbers one after another
    int last_window_ = 0;
    bool open_ = false;
};

}  // namespace drape
