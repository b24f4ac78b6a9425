// What GLUT brings: keys, buttons, the pointer, the menu, and the window's own events.

#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <utility>

#include "display.h"
#include "keys.h"
#include "window.h"

namespace drape {

void Window::register_callbacks() {
    // Repeats are not ignored where they can be told: freeglut would lose keys that follow while a picture is drawn
    if (!make_repeats_detectable()) glutIgnoreKeyRepeat(1);
    glutDisplayFuncUcall(Callback<&Window::on_display>::call, this);
    glutReshapeFuncUcall(Callback<&Window::on_reshape>::call, this);
    glutEntryFuncUcall(Callback<&Window::on_entry>::call, this);
    glutVisibilityFuncUcall(Callback<&Window::on_visibility>::call, this);
    glutCloseFuncUcall(Callback<&Window::on_close>::call, this);
    glutMouseFuncUcall(Callback<&Window::on_button>::call, this);
    glutMotionFuncUcall(Callback<&Window::on_motion>::call, this);
    glutPassiveMotionFuncUcall(Callback<&Window::on_passive_motion>::call, this);
    glutMouseWheelFuncUcall(Callback<&Window::on_wheel>::call, this);
    glutKeyboardFuncUcall(Callback<&Window::on_character>::call, this);
    glutKeyboardUpFuncUcall(Callback<&Window::on_character_up>::call, this);
    glutSpecialFuncUcall(Callback<&Window::on_special>::call, this);
    glutSpecialUpFuncUcall(Callback<&Window::on_special_up>::call, this);
    menu_.emplace(entries_, renderer_->panels().display_scale, Callback<&Window::on_choice>::call, this);
    glutMenuStatusFuncUcall(Callback<&Window::on_menu>::call, this);
}

void Window::on_character(unsigned char code, int, int) {
    const int modifiers = glutGetModifiers();
    const bool shift = (modifiers & GLUT_ACTIVE_SHIFT) != 0, control = (modifiers & GLUT_ACTIVE_CTRL) != 0;
    const std::string key = character_key(code, shift, control);
    // A shortcut acts in a field too; a digit may be typed while the Ctrl of a Ctrl+click is still down
    if (renderer_->panels().have_keyboard() && !(control && find_entry(entries_, key) != nullptr)) {
        held_keys_.insert(without_modifiers(key));
        return type_at_panel(code);
    }
    if ((modifiers & GLUT_ACTIVE_ALT) == 0) press(key);
}

void Window::on_character_up(unsigned char code, int, int) {
    const bool control = (glutGetModifiers() & GLUT_ACTIVE_CTRL) != 0;
    release(without_modifiers(character_key(code, false, control)));
}

void Window::type_at_panel(unsigned char code) {
    panel_frames_ = 8;
    renderer_->panels().type(code);
    take_panel_changes();
}

void Window::on_special(int code, int, int) {
    if ((code == GLUT_KEY_UP || code == GLUT_KEY_DOWN) && renderer_->panels().menu_open()) {
        held_keys_.insert(special_key(code, false));
        return type_at_panel(code == GLUT_KEY_UP ? 16 : 14);
    }
    if (renderer_->panels().have_keyboard()) return;
    press(special_key(code, (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0));
}

void Window::on_special_up(int code, int, int) { release(special_key(code, false)); }

void Window::release(const std::string& key) {
    // A key that Shift has changed in between has another name by now
    if (held_keys_.erase(key) == 0) held_keys_.clear();
    steering_.release(key);
}

void Window::press(const std::string& key) {
    if (!held_keys_.insert(without_modifiers(key)).second) return;  // it repeats
    forget_hint();
    if (key == "Esc" && close_topmost()) return;
    const Entry* entry = find_entry(entries_, key);
    if (entry == nullptr) return;
    if (entry->manner == Manner::WhileHeld) return steering_.press(key, *entry);
    give(*entry);
}

void Window::on_choice(int number) {
    const Entry& entry = entries_.at(static_cast<std::size_t>(number));
    if (entry.manner == Manner::WhileHeld) return steering_.nudge(entry);
    give(entry);
}

// What lies over the others, first. In the end it asks, and finds nothing to close while the question is on show
bool Window::close_topmost() {
    const ViewSettings& view = session_.simulation().settings().view;
    const Timeline timeline = session_.timeline();
    if (menu_->open()) {
        click_beside_menus();
    } else if (renderer_->panels().close_list()) {
        panel_frames_ = 8;
    } else if (view.help) {
        carry_out(command::Set{"view.help=false"});
    } else if (view.controls) {
        carry_out(command::Set{"view.controls=false"});
    } else if (touring_) {
        leave_tour();
    } else if (session_.compares()) {
        carry_out(command::Compare{"none"});
    } else if (timeline.replay) {
        session_.leave_replay();
    } else if (!timeline.is_live()) {
        go_to(timeline.newest);
    } else if (!notices_.shows("quit")) {
        notices_.add("quit", "Press Esc again to quit");
        dirty_ = true;
    } else {
        return false;
    }
    return true;
}

// The tour's stays
void Window::forget_hint() {
    if (touring_ || renderer_->panels().hint.empty()) return;
    renderer_->panels().hint = {};
    dirty_ = true;
}

void Window::on_menu(int status, int, int) {
    const bool open = status == GLUT_MENU_IN_USE;
    forget_hint();
    menu_->set_open(open);
    if (renderer_->panels().menu_open()) type_at_panel(27);
    if (open) steering_.release_all();
}

void Window::on_button(int button, int state, int x, int y) {
    constexpr int wheel_up = 3, wheel_down = 4;  // where the wheel comes as buttons
    if (button == wheel_up || button == wheel_down) {
        if (state == GLUT_DOWN) on_wheel(0, button == wheel_up ? 1 : -1, x, y);
        return;
    }
    if ((button != GLUT_LEFT_BUTTON && button != GLUT_MIDDLE_BUTTON) || !drawable()) return;
    if (button == GLUT_MIDDLE_BUTTON && renderer_->panels().menu_open()) return;
    const auto which = button == GLUT_LEFT_BUTTON ? Pointer::Button::Left : Pointer::Button::Middle;
    const int modifiers = glutGetModifiers();
    const Pointer::Modifiers held{(modifiers & GLUT_ACTIVE_SHIFT) != 0, (modifiers & GLUT_ACTIVE_CTRL) != 0};
    const bool down = state == GLUT_DOWN;
    if (which == Pointer::Button::Left) {
        const bool was_at_panel = std::exchange(panel_button_, false);
        const bool is_at_panel = at_panel({.x = x, .y = y, .down = down, .control = held.control});
        panel_button_ = down && is_at_panel;
        panel_presses_ += panel_button_ ? 1 : 0;
        if (is_at_panel || was_at_panel) return;
    }
    const Sight sight{session_.view(), shown_, width_, height_};
    if (down) {
        forget_hint();
        carry_out(pointer_.press(which, held, x, y, sight));
        if (pointer_.orbits_from_ball()) notices_.add("ball", "The hand does not move this ball: the view turns");
    } else {
        pointer_.move(x, y);
        carry_out(pointer_.release(which, sight));
    }
}

bool Window::at_panel(const PanelPointer& pointer) {
    renderer_->panels().hover_x = pointer.x, renderer_->panels().hover_y = pointer.y;
    const bool any = session_.simulation().settings().view.controls || renderer_->panels().shows_timeline();
    if (!any && !renderer_->panels().menu_open()) return false;
    constexpr int frames = 8;  // that a press, a release and what follows from them take to be seen
    renderer_->panels().point(pointer);
    panel_frames_ = frames;
    const bool is_drawn = renderer_->report().frame > 0;  // until then nobody knows where it is
    return (renderer_->panels().have_pointer() || !is_drawn) && !pointer_.busy();
}

void Window::on_motion(int x, int y) {
    at_panel({.x = x, .y = y, .down = panel_button_});
    pointer_.move(x, y);
}

void Window::on_passive_motion(int x, int y) {
    at_panel({.x = x, .y = y});
    panel_frames_ = 8;  // it may be over a figure or a node, which is explained there
}

void Window::on_wheel(int, int notches, int x, int y) {
    if (!at_panel({.x = x, .y = y, .down = panel_button_, .notches = notches})) carry_out(Pointer::wheel(notches));
}

void Window::on_entry(int state) {
    if (state == GLUT_LEFT) on_passive_motion(-1, -1);
}

void Window::on_visibility(int state) {
    visible_ = state == GLUT_VISIBLE;
    dirty_ = true;
}

void Window::on_reshape(int width, int height) {
    width_ = width;
    height_ = height;
    if (glutGet(GLUT_FULL_SCREEN) == 0) kept_size_ = {width, height};
    unshown_.reset();
    if (renderer_) renderer_->resize(width, height);
    video_.resize({width, height});
    dirty_ = true;
}

}  // namespace drape
