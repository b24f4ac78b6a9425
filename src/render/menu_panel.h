#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "drape/render/entries.h"
#include "drape/sim/frame_view.h"
#include "settings_panel.h"

namespace drape {

/// The drawn menu in the middle of the picture: the entries of keys and popup menu, the settings, and a field that
/// searches them. While it is open, keyboard and pointer are its own. It carries out no entry by itself; of a setting
/// that is chosen, the settings panel shows the row.
class MenuPanel {
public:
    MenuPanel(SettingsPanel& settings, PanelWishes& wishes) : settings_(settings), wishes_(wishes) {}

    /// Opens it with these entries and the settings that a scene has.
    void open(std::span<const Entry> entries, const Settings& settings);
    [[nodiscard]] bool is_open() const { return open_; }

    /// A character for it, as `Panels::type` has them.
    void type(unsigned char code);

    /// Makes it, if it is open.
    void draw(const FrameView& view, const OverlayPage& page);

private:
    struct Item {
        std::string group, text, keys;
        std::string searched;  ///< in small letters
        MenuMark mark;
        const Setting* setting = nullptr;  ///< null: an entry
        bool is_idle = false;              ///< a setting without effect
    };

    void search();
    void choose();
    void draw_row(std::size_t row, const FrameView& view);

    SettingsPanel& settings_;
    PanelWishes& wishes_;
    std::vector<Item> items_;         ///< entries, then settings
    std::vector<std::size_t> found_;  ///< items that fit the query, the best first
    std::size_t row_ = 0;             ///< of these, the one that Enter chooses
    std::string query_;               ///< in small letters
    bool open_ = false;
    bool moved_ = false;  ///< the row has to be scrolled to
};

}  // namespace drape
