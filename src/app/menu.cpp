#include "menu.h"

#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <algorithm>
#include <optional>

#include "drape/sim/setting_table.h"

namespace drape {

namespace {

// Whether what an entry switches or chooses is on; nothing for entries that do neither.
std::optional<bool> is_on(const Command& command, const Simulation& simulation) {
    if (std::holds_alternative<command::Pause>(command)) return simulation.paused();
    if (const auto* load = std::get_if<command::LoadScene>(&command)) return simulation.scene() == load->name;
    if (const auto* next = std::get_if<command::Next>(&command)) {
        const SettingValue value = find_setting(next->setting).read(simulation.settings(), 0);
        if (const bool* flag = std::get_if<bool>(&value)) return *flag;
    }
    if (const auto* set = std::get_if<command::Set>(&command)) {
        const std::size_t equals = set->assignment.find('=');
        const Setting& setting = find_setting(std::string_view(set->assignment).substr(0, equals));
        return value_text(setting.read(simulation.settings(), 0)) == set->assignment.substr(equals + 1);
    }
    return std::nullopt;
}

std::string mark(const Command& command, bool on) {
    if (std::holds_alternative<command::Pause>(command)) return on ? "  - paused" : "";
    if (std::holds_alternative<command::Next>(command)) return on ? "  - on" : "  - off";
    return on ? "  - now" : "";
}

}  // namespace

std::string menu_text(const Entry& entry, const Simulation& simulation) {
    std::string text = entry.text;
    if (!entry.keys.empty()) text += "  (" + key_text(entry) + ")";
    const Command command = parse_command(entry.command);
    if (const std::optional<bool> on = is_on(command, simulation)) text += mark(command, *on);
    return text;
}

Menu::Menu(const std::vector<Entry>& entries, void (*choose)(int entry, void* user), void* user) {
    struct Submenu {
        std::string title;
        int number;
        int length;
    };
    std::vector<Submenu> menus{{"", glutCreateMenuUcall(choose, user), 0}};
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const Entry& entry = entries[e];
        auto menu = std::ranges::find(menus, entry.menu, &Submenu::title);
        if (menu == menus.end()) {
            menus.push_back({entry.menu, glutCreateMenuUcall(choose, user), 0});
            menu = menus.end() - 1;
            glutSetMenu(menus.front().number);
            glutAddSubMenu(menu->title.c_str(), menu->number);
            ++menus.front().length;
        }
        glutSetMenu(menu->number);
        glutAddMenuEntry(entry.text.c_str(), static_cast<int>(e));
        items_.push_back({&entry, menu->number, ++menu->length, entry.text});
    }
    first_window_ = glutGetWindow() + 1;
    last_window_ = glutGetWindow() + static_cast<int>(menus.size());
    glutSetMenu(menus.front().number);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
}

void Menu::draw_again() const {
    for (int window = first_window_; window <= last_window_; ++window) glutPostWindowRedisplay(window);
}

void Menu::update(const Simulation& simulation) {
    if (open_) return draw_again();
    int number = 0;
    for (Item& item : items_) {
        std::string text = menu_text(*item.entry, simulation);
        if (text != item.shown) {
            glutSetMenu(item.menu);
            glutChangeToMenuEntry(item.position, text.c_str(), number);
            item.shown = std::move(text);
        }
        ++number;
    }
}

}  // namespace drape
