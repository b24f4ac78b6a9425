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

Menu::Menu(const std::vector<Entry>& entries, void (*choose)(int entry, void* user), void* user) {
    std::vector<Submenu> menus{{"", glutCreateMenuUcall(choose, user), 0}};
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const Entry& entry = entries[e];
        Submenu* const menu = &menus[submenu(entry.menu, menus, choose, user)];
        glutSetMenu(menu->number);
        glutAddMenuEntry(entry.text.c_str(), static_cast<int>(e));
        items_.push_back({with_keys(entry), MenuMark(entry), menu->number, ++menu->length, entry.text});
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
        const auto mark = item.mark.text(simulation.settings(), simulation.scene(), simulation.paused());
        std::string text = item.text + (mark.empty() ? "" : "  - ") + std::string(mark);
        if (text != item.shown) {
            glutSetMenu(item.menu);
            glutChangeToMenuEntry(item.position, text.c_str(), number);
            item.shown = std::move(text);
        }
        ++number;
    }
}

}  // namespace drape
