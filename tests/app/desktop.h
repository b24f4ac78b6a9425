#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "drape/render/image.h"
#include "support/process.h"

namespace drape::test {

/// A place on the screen, in pixels from the top left.
struct Place {
    int x;
    int y;
};

/// An X server of the test's own, without a screen and without a window manager, and a hand on its keyboard and mouse.
class Desktop {
public:
    /// @param folder for what the programs write
    explicit Desktop(std::filesystem::path folder);

    [[nodiscard]] const std::string& display() const { return display_; }

    /// Runs xdotool. @return what it prints, without the last line's end
    std::string act(const std::vector<std::string>& words);

    /// Waits for the window of `drape` and gives it keyboard and pointer. @return its number; empty if it did not come
    std::string find_window();

    void key(const std::string& name) { act({"key", name}); }
    void move_to(int x, int y) { act({"mousemove", std::to_string(x), std::to_string(y)}); }
    void click(int button) { act({"click", std::to_string(button)}); }

    /// Presses a button at one place and lets it go at another, with keys held.
    void drag(const std::vector<std::string>& keys, int button, Place from, Place to);

    /// Holds a key down until the server has repeated it some times.
    void hold(const std::string& name, const std::string& window, int repeats);

    /// Opens the popup menu at a place, and waits until it is there.
    void open_menu(int x, int y);

    /// Opens the popup menu at a place and chooses one of its entries, counted from 1; waits until it is gone.
    void choose_in_menu(int x, int y, int entry);

    /// What the user has set for all programs, as "Xft.dpi: 192".
    void set_resources(const std::string& text);

    /// Gives the keyboard to no window at all.
    void take_keyboard_away();

    /// What a window manager sends when its close button is pressed.
    void ask_to_close(const std::string& window);

    /// What a window shows now; nothing covers it.
    [[nodiscard]] Image picture_of(const std::string& window) const;

    /// Windows and menus that are on show.
    [[nodiscard]] int visible_windows() const;

private:
    std::filesystem::path folder_;
    std::string display_;
    std::unique_ptr<Process> server_;
};

}  // namespace drape::test
