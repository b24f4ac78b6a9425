#include "menu.h"

#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <algorithm>

namespace drape {

namespace {

struct Submenu {
    std::string path;
    int number;  // GLUT's
    int length;  // in entries
};

// The index of the submenu at a path; makes it, and those around it, where they are not there yet.
std::size_t submenu(const std::string& path, std::vector<Submenu>& menus, void (*choose)(int entry, void* user),
                    void* user) {
    const auto found = std::ranges::find(menus, path, &Submenu::path);
    if (found != menus.end()) return static_cast<std::size_t>(found - menus.begin());
    const std::size_t slash = path.rfind('/');
    const bool is_nested = slash != std::string::npos;
    Submenu& around = menus[submenu(is_nested ? path.substr(0, slash) : "", menus, choose, user)];
    const int number = glutCreateMenuUcall(choose, user);
    glutSetMenu(around.number);
    glutAddSubMenu(path.substr(is_nested ? slash + 1 : 0).c_str(), number);
    ++around.length;
    menus.push_back({path, number, 0});
    return menus.size() - 1;
}

std::string with_keys(const Entry& entry) {
    return entry.keys.empty() ? entry.text : entry.text + "  (" + key_text(entry) + ")";
}

}  // namespace

MenuMark::MenuMark(std::string_view command) : command_(parse_command(command)) {
    if (const auto* next = std::get_if<command::Next>(&command_)) setting_ = &find_setting(next->setting);
    if (const auto* set = std::get_if<command::Set>(&command_)) {
        const std::string_view assignment = set->assignment;
        const std::size_t equals = assignment.find('=');
        setting_ = &find_setting(assignment.substr(0, equals));
        value_ = parse_value(*setting_, assignment.substr(equals + 1));
    }
}

std::string MenuMark::text(const Simulation& simulation) const {
    const auto now = [](bool is_present) { return is_present ? "  - now" : ""; };
    if (std::holds_alternative<command::Pause>(command_)) return simulation.paused() ? "  - paused" : "";
    if (const auto* load = std::get_if<command::LoadScene>(&command_)) return now(simulation.scene() == load->name);
    if (setting_ == nullptr) return "";
    const SettingValue present = setting_->read(simulation.settings(), 0);
    if (value_) return now(present == *value_);
    const bool* flag = std::get_if<bool>(&present);
    if (flag == nullptr) return "";
    return *flag ? "  - on" : "  - off";
}

Menu::Menu(const std::vector<Entry>& entries, void (*choose)(int entry, void* user), void* user) {
    std::vector<Submenu> menus{{"", glutCreateMenuUcall(choose, user), 0}};
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const Entry& entry = entries[e];
        Submenu* const menu = &menus[submenu(entry.menu, menus, choose, user)];
        glutSetMenu(menu->number);
        glutAddMenuEntry(entry.text.c_str(), static_cast<int>(e));
        // What an entry sets by itself is no choice among others
        const bool is_choice =
            entry.manner == Manner::Once && !(entry.menu.empty() && entry.command.starts_with("set "));
        items_.push_back(
            {with_keys(entry), MenuMark(is_choice ? entry.command : "quit"), menu->number, ++menu->length, entry.text});
    }
    first_window_ = glutGetWindow() + 1;
    last_window_ = glutGetWindow() + static_cast<int>(menus.size());
    glutSetMenu(menus.front().number);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
}

void Menu::set_open(bool open) {
    open_ = open;
    if (open_) return;
    const int present = glutGetWindow();
    for (int window = first_window_; window <= last_window_; ++window) {
        glutSetWindow(window);
        glutHideWindow();
    }
    glutSetWindow(present);
}

void Menu::update(const Simulation& simulation) {
    for (int window = first_window_; open_ && window <= last_window_; ++window) glutPostWindowRedisplay(window);
    if (open_) return;
    int number = 0;
    for (Item& item : items_) {
        std::string text = item.text + item.mark.text(simulation);
        if (text != item.shown) {
            glutSetMenu(item.menu);
            glutChangeToMenuEntry(item.position, text.c_str(), number);
            item.shown = std::move(text);
        }
        ++number;
    }
}

}  // namespace drape
