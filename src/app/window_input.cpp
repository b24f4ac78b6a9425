// What the user does to the window, and what becomes of it.

#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <cmath>
#include <filesystem>

#include "display.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "keys.h"
#include "window.h"

namespace drape {

namespace {

constexpr int wheel_up = 3, wheel_down = 4;  // buttons, where the wheel comes as such

// Writes "drape-0007.png", the first that is not there yet.
std::filesystem::path write_next(const Image& picture) {
    for (int number = 1;; ++number) {
        std::string digits = std::to_string(number);
        if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
        std::filesystem::path file = "drape-" + digits + ".png";
        if (!exists(symlink_status(file)) && write_new_png(picture, file)) return file;
    }
}

}  // namespace

void Window::register_callbacks() {
    glutIgnoreKeyRepeat(1);
    make_repeats_detectable();
    glutDisplayFuncUcall([](void* user) { guarded_call(user, &Window::on_display); }, this);
    glutReshapeFuncUcall([](int w, int h, void* user) { guarded_call(user, &Window::on_reshape, w, h); }, this);
    glutVisibilityFuncUcall([](int state, void* user) { guarded_call(user, &Window::on_visibility, state); }, this);
    glutCloseFuncUcall([](void* user) { guarded_call(user, &Window::on_close); }, this);
    glutMouseFuncUcall([](int button, int state, int x, int y,
                          void* user) { guarded_call(user, &Window::on_button, button, state, x, y); },
                       this);
    glutMotionFuncUcall([](int x, int y, void* user) { guarded_call(user, &Window::on_motion, x, y); }, this);
    glutMouseWheelFuncUcall(
        [](int, int notches, int, int, void* user) { guarded_call(user, &Window::on_wheel, notches); }, this);
    glutKeyboardFuncUcall(
        [](unsigned char code, int, int, void* user) { guarded_call(user, &Window::on_character, code, true); }, this);
    glutKeyboardUpFuncUcall(
        [](unsigned char code, int, int, void* user) { guarded_call(user, &Window::on_character, code, false); }, this);
    glutSpecialFuncUcall(
        [](int code, int, int, void* user) { guarded_call(user, &Window::on_key, special_key(code), true); }, this);
    glutSpecialUpFuncUcall(
        [](int code, int, int, void* user) { guarded_call(user, &Window::on_key, special_key(code), false); }, this);
    menu_.emplace(
        entries_, [](int entry, void* user) { guarded_call(user, &Window::on_choice, entry); }, this);
    glutMenuStatusFuncUcall(
        [](int status, int, int, void* user) { guarded_call(user, &Window::on_menu, status == GLUT_MENU_IN_USE); },
        this);
}

void Window::on_character(unsigned char code, bool down) {
    const int modifiers = glutGetModifiers();
    if (down && (modifiers & (GLUT_ACTIVE_CTRL | GLUT_ACTIVE_ALT)) != 0) return;
    on_key(character_key(code, (modifiers & GLUT_ACTIVE_SHIFT) != 0), down);
}

void Window::on_key(const std::string& key, bool down) {
    if (!down) {
        // A key that Shift has changed in between has another name by now
        if (held_keys_.erase(without_shift(key)) == 0) held_keys_.clear();
        return steering_.release(key);
    }
    if (!held_keys_.insert(without_shift(key)).second) return;  // it repeats
    const Entry* entry = find_entry(entries_, key);
    if (entry == nullptr) return;
    if (entry->manner == Manner::WhileHeld) return steering_.press(key, *entry);
    carry_out(command_of(*entry));
}

void Window::on_choice(int number) {
    const Entry& entry = entries_.at(static_cast<std::size_t>(number));
    if (entry.manner == Manner::WhileHeld) return steering_.nudge(entry);
    carry_out(command_of(entry));
}

void Window::on_menu(bool open) {
    menu_->set_open(open);
    if (open) steering_.release_all();
}

void Window::on_button(int button, int state, int x, int y) {
    if (button == wheel_up || button == wheel_down) {
        if (state == GLUT_DOWN) on_wheel(button == wheel_up ? 1 : -1);
        return;
    }
    if ((button != GLUT_LEFT_BUTTON && button != GLUT_MIDDLE_BUTTON) || !drawable()) return;
    const auto which = button == GLUT_LEFT_BUTTON ? Pointer::Button::Left : Pointer::Button::Middle;
    const bool shift = (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
    const Sight sight{session_.view(), camera_, width_, height_};
    if (state == GLUT_DOWN) {
        carry_out(pointer_.press(which, shift, x, y, sight));
    } else {
        pointer_.move(x, y);
        carry_out(pointer_.release(which, sight));
    }
}

void Window::on_motion(int x, int y) { pointer_.move(x, y); }

void Window::on_wheel(int notches) { carry_out(Pointer::wheel(notches)); }

void Window::on_visibility(int state) {
    visible_ = state == GLUT_VISIBLE;
    dirty_ = true;
}

void Window::on_reshape(int width, int height) {
    width_ = width;
    height_ = height;
    if (renderer_) renderer_->resize(width, height);
    dirty_ = true;
}

Command Window::command_of(const Entry& entry) {
    if (entry.manner == Manner::Aimed) return camera_.aimed_throw();
    if (entry.manner == Manner::OneFrame) {
        const double steps = 1.0 / 60 / session_.simulation().settings().solver.dt;
        return command::Step{std::max(1, static_cast<int>(std::lround(steps)))};
    }
    return parse_command(entry.command);
}

void Window::carry_out(const std::vector<Command>& commands) {
    for (const Command& command : commands) carry_out(command);
}

void Window::carry_out(const Command& command) {
    dirty_ = true;
    try {
        session_.send(command);
    } catch (const InputError& error) {
        return notices_.add("input", error.what());
    }
    camera_.apply(command, session_.view());
    if (std::holds_alternative<command::Picture>(command)) take_picture();
    if (std::holds_alternative<command::Quit>(command)) leave();
    if (std::holds_alternative<command::LoadScene>(command)) start_scene();
    if (std::holds_alternative<command::LoadScene>(command) || std::holds_alternative<command::Reset>(command)) {
        pointer_.forget();
        steering_.forget_given();
    }
}

void Window::take_picture() {
    if (!drawable() || closed_) return;
    try {
        draw();
        notices_.add("picture", "Picture written: " + write_next(renderer_->read_back()).string());
    } catch (const RunError& error) {
        notices_.add("picture", error.what());
    }
}

}  // namespace drape
