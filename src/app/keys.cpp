#include "keys.h"

#include <GL/freeglut.h>

#include <array>
#include <utility>

namespace drape {

std::string character_key(unsigned char code, bool shift, bool control) {
    constexpr int letters = 26;  // which Control turns into the codes from 1 on
    const std::string modifiers = std::string(control ? "Ctrl+" : "") + (shift ? "Shift+" : "");
    if (control) return code >= 1 && code <= letters ? modifiers + static_cast<char>('A' + code - 1) : "";
    if (code == ' ') return "Space";
    if (code == '\t') return "Tab";
    if (code == 27) return "Esc";
    // Caps Lock changes the letter but not the key.
    const bool small = code >= 'a' && code <= 'z';
    if (small || (code >= 'A' && code <= 'Z')) {
        const char letter = static_cast<char>(small ? code - 'a' + 'A' : code);
        return modifiers + letter;
    }
    return code > ' ' && code < 127 ? std::string(1, static_cast<char>(code)) : std::string();
}

std::string special_key(int code, bool shift) {
    static constexpr std::array<std::pair<int, const char*>, 6> names{{{GLUT_KEY_LEFT, "Left"},
                                                                       {GLUT_KEY_RIGHT, "Right"},
                                                                       {GLUT_KEY_UP, "Up"},
                                                                       {GLUT_KEY_DOWN, "Down"},
                                                                       {GLUT_KEY_PAGE_UP, "PageUp"},
                                                                       {GLUT_KEY_PAGE_DOWN, "PageDown"}}};
    for (const auto& [key, name] : names) {
        if (key == code) return name;
    }
    if (code >= GLUT_KEY_F1 && code <= GLUT_KEY_F12) {
        return (shift ? "Shift+F" : "F") + std::to_string(code - GLUT_KEY_F1 + 1);
    }
    return {};
}

std::string without_modifiers(const std::string& key) {
    const std::size_t plus = key.rfind('+');
    return key.size() > 1 && plus != std::string::npos ? key.substr(plus + 1) : key;
}

}  // namespace drape
