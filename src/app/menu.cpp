#include "menu.h"

#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <map>

namespace drape {

namespace {

// GLUT's number of the submenu at a path; makes it, and those around it, where they are not there yet.
int submenu(const std::string& path, std::map<std::string, int>& menus, void (*choose)(int entry, void* user),
            void* user) {
    if (const auto found = menus.find(path); found != menus.end()) return found->second;
    const std::size_t slash = path.rfind('/');
    const bool is_nested = slash != std::string::npos;
    const int around = submenu(is_nested ? path.substr(0, slash) : "", menus, choose, user);
    const int number = menus[path] = glutCreateMenuUcall(choose, user);
    glutSetMenu(around);
    glutAddSubMenu(path.substr(is_nested ? slash + 1 : 0).c_str(), number);
    return number;
}

std::string with_keys(const Entry& entry) {
    return entry.keys.empty() ? entry.text : entry.text + "  (" + key_text(entry) + ")";
}

}  // namespace

Menu::Menu(const std::vector<Entry>& entries, double display_scale, void (*choose)(int entry, void* user), void* user) {
    std::map<std::string, int> menus{{"", glutCreateMenuUcall(choose, user)}};
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const Entry& entry = entries[e];
        const int menu = submenu(entry.menu, menus, choose, user);
        glutSetMenu(menu);
        glutAddMenuEntry(entry.text.c_str(), static_cast<int>(e));
        items_.push_back({with_keys(entry), MenuMark(entry), menu, glutGet(GLUT_MENU_NUM_ITEMS), entry.text});
    }
    void* const font = display_scale < 1.25 ? GLUT_BITMAP_HELVETICA_18 : GLUT_BITMAP_TIMES_ROMAN_24;
    for (const auto& [path, number] : menus) glutSetMenuFont(number, font);
    first_window_ = glutGetWindow() + 1;
    last_window_ = glutGetWindow() + static_cast<int>(menus.size());
    glutSetMenu(menus[""]);
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
        const std::string mark = item.mark.text(simulation.settings(), simulation.scene(), simulation.paused());
        std::string text = item.text + (mark.empty() ? "" : "  - ") + mark;
        if (text != item.shown) {
            glutSetMenu(item.menu);
            glutChangeToMenuEntry(item.position, text.c_str(), number);
            item.shown = std::move(text);
        }
        ++number;
    }
}

}  // namespace drape
