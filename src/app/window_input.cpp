// What the user does to the window, and what becomes of it.

#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "display.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"
#include "drape/session/comparison.h"
#include "drape/session/recording.h"
#include "drape/session/start.h"
#include "drape/session/tour.h"
#include "keys.h"
#include "outcome.h"
#include "window.h"

namespace drape {

namespace {

// Kept in the range of the setting
command::Set set_speed(double speed) {
    const Range range = find_setting("view.speed").range;
    return {"view.speed=" + real_text(std::clamp(speed, range.low, range.high), 4)};
}

constexpr int wheel_up = 3, wheel_down = 4;  // buttons, where the wheel comes as such

}  // namespace

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
    if (renderer_->panels().have_keyboard()) {
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

void Window::give(const Entry& entry) {
    dirty_ = true;
    if (entry.manner == Manner::Compare) {
        if (!carry_out(parse_command(entry.command))) return;
        for (const std::string& change : split_assignments(entry.change)) carry_out(command::Set{change});
        carry_out(command::Compare{entry.versus});
        return;
    }
    if (entry.manner == Manner::Search) {
        steering_.release_all();
        std::erase_if(entries_, [](const Entry& old) { return old.manner == Manner::ReplayFile; });
        for (const std::string& file : recordings_in(".")) {
            if (one_line(file) == file) entries_.push_back({"Replay recording", {}, file, "", Manner::ReplayFile});
        }
        return renderer_->panels().open_menu(entries_, session_.simulation().settings());
    }
    if (entry.manner == Manner::Fullscreen) {
        pointer_.forget();
        return glutFullScreenToggle();
    }
    if (entry.manner == Manner::SaveRecording) {
        return write_new("Recording", ".txt",
                         [&](const std::filesystem::path& file) { return session_.save_recording(file); });
    }
    if (entry.manner == Manner::ReplayRun) return replay_run();
    if (entry.manner == Manner::ReplayFile) return replay_file(entry.text);
    if (entry.manner == Manner::StepBack) return go_to(session_.timeline().now - 1);
    if (entry.manner == Manner::FrameBack) return go_to(session_.timeline().now - steps_of_a_frame());
    if (entry.manner == Manner::Reload) return touring_ ? go_to_stop(stop_) : reload_scene();
    if (entry.manner == Manner::NextStop) return go_to_stop(touring_ ? stop_ + 1 : stop_);
    if (entry.manner == Manner::StopBefore) return go_to_stop(stop_ - 1);
    if (entry.manner == Manner::Undo || entry.manner == Manner::Redo) return undo(entry.manner == Manner::Redo);
    for (const Command& command : commands_of(entry)) {
        if (!change(command)) continue;
        const std::string outcome = outcome_of(command, session_.simulation());
        if (!outcome.empty()) notices_.add("outcome", outcome);
    }
}

void Window::go_to_stop(int stop) {
    const auto stops = tour_stops();
    const int count = static_cast<int>(stops.size());
    stop_ = (stop + count) % count;
    const bool was_paused = session_.simulation().paused();
    carry_out(drape::commands_of(stops[static_cast<std::size_t>(stop_)]));
    if (was_paused) carry_out(command::Pause{});
    camera_ = shown_ = Camera(session_.simulation().settings().view);
    renderer_->panels().hint = tour_hint(static_cast<std::size_t>(stop_));
    renderer_->panels().set_scene(session_.simulation().settings());
    touring_ = true;
}

// Its scene stays, without what it was compared with
void Window::leave_tour() {
    touring_ = false;
    if (session_.compares()) carry_out(command::Compare{"none"});
    renderer_->panels().hint = {};
    notices_.add("tour", "The tour has ended; F1 takes it up again");
    dirty_ = true;
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
    const Panels& panels = renderer_->panels();
    const bool was_at_figures = panels.at_figures();
    at_panel({.x = x, .y = y});
    if (was_at_figures || panels.at_figures()) panel_frames_ = 8;
    dirty_ |= session_.simulation().settings().view.bounds;
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

std::vector<Command> Window::commands_of(const Entry& entry) {
    const double speed = session_.simulation().settings().view.speed;
    if (entry.manner == Manner::Aimed) return {camera_.aimed_throw()};
    if (entry.manner == Manner::OneFrame) return {command::Step{static_cast<int>(steps_of_a_frame())}};
    if (entry.manner == Manner::SafeStep) return safe_step();
    if (entry.manner == Manner::Slower) return {set_speed(speed / 2)};
    if (entry.manner == Manner::Faster) return {set_speed(speed * 2)};
    return {parse_command(entry.command)};
}

std::int64_t Window::steps_of_a_frame() const {
    return std::max(1L, std::lround(1.0 / 60 / session_.simulation().settings().solver.dt));
}

void Window::go_to(std::int64_t step) {
    dirty_ = true;
    pointer_.forget();
    steering_.release_all();
    session_.go_to(step);
    steering_.forget_given();
    if (step < session_.timeline().oldest) notices_.add("time", "Nothing is kept of what was before");
}

void Window::replay_run() {
    const Timeline timeline = session_.timeline();
    if (timeline.start == timeline.newest) return notices_.add("time", "There is nothing to replay");
    go_to(timeline.start);
    carry_out(command::Pause{});
}

// A mistake in it changes nothing
void Window::replay_file(const std::string& file) {
    try {
        Start start = make_start({.replay = file});
        load_scene_first(*start.replay);
        pointer_.forget();
        steering_.release_all();
        if (session_.simulation().paused()) carry_out(command::Pause{});
        session_.replay(*std::move(start.replay));
    } catch (const InputError& error) {
        notices_.add("input", error.what());
    }
}

std::vector<Command> Window::safe_step() {
    const double longest = session_.simulation().longest_step();
    if (!(longest > 0) || !std::isfinite(longest)) return {command::Reset{}};
    if (session_.simulation().settings().solver.dt <= 0.9 * longest) return {command::Reset{}};
    return {command::Set{"solver.dt=" + real_text(0.9 * longest, 3)}, command::Reset{}};
}

// By the user, who may take it back where it is one of a setting; what is seen is no part of the run
bool Window::change(const Command& command, int press) {
    const Settings& settings = session_.simulation().settings();
    const std::string name(setting_of(command));
    if (name.empty() || !changes_motion(command)) return carry_out(command);
    std::vector<std::string> before = assignments_of(settings, name);
    const std::int64_t step = session_.timeline().now;
    if (!carry_out(command)) return false;
    undo_.changed(step, name, std::move(before), assignments_of(settings, name), press);
    return true;
}

// A run that has diverged since goes on from where the change was made, or begins again where that is forgotten
void Window::undo(bool again) {
    const Simulation& simulation = session_.simulation();
    const SettingUndo::Move move = undo_.next(again, simulation.settings(), session_.timeline().now);
    const bool goes_back = simulation.report().status == Status::Diverged && !again && !move.assignments.empty();
    const bool is_kept = move.step >= session_.timeline().oldest, was_paused = simulation.paused();
    if (goes_back && is_kept) go_to(move.step);
    if (goes_back && !is_kept) carry_out(command::Reset{});
    std::string outcome;
    for (const std::string& assignment : move.assignments) {
        if (!carry_out(command::Set{assignment})) return;
        outcome += (outcome.empty() ? "" : ", ") + shortened(assignment);
    }
    if (simulation.paused() != was_paused) carry_out(command::Pause{});
    notices_.add("outcome", outcome.empty()
                                ? "No change of a setting is left to " + std::string(again ? "redo" : "undo")
                                : outcome + " again");
}

void Window::carry_out(const std::vector<Command>& commands) {
    for (const Command& command : commands) carry_out(command);
}

bool Window::carry_out(const Command& command) {
    dirty_ = true;
    try {
        session_.send(command);
    } catch (const InputError& error) {
        notices_.add("input", error.what());
        return false;
    } catch (const RunError& error) {
        // A run goes on where memory is too little for another one beside it
        if (!std::holds_alternative<command::Compare>(command)) throw;
        notices_.add("input", error.what());
        return false;
    }
    follow(command);
    if (std::holds_alternative<command::Picture>(command)) take_picture();
    if (std::holds_alternative<command::Video>(command) && drawable() && !closed_) {
        notices_.add("video", video_.toggle({width_, height_}));
    }
    if (std::holds_alternative<command::Quit>(command)) leave();
    return true;
}

// What the session has carried out
void Window::follow(const Command& command) {
    shot_repeat_.follow(command);
    camera_.apply(command, session_.view());
    if (changes_scene(command)) start_scene();
    if (!begins_again(command)) return;
    pointer_.forget();
    steering_.forget_given();
    told_failure_.clear();
    sees_ball_ = false;
    for (const char* topic : {"dropped", "crossing", "ball"}) notices_.remove(topic);
    scene_clock_ = {};
    unshown_.reset();  // a picture of what was before
    dirty_ = true;
}

}  // namespace drape
