// What is carried out: an entry of the menu or its key, a command, what takes one back.

#include <GL/freeglut.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"
#include "drape/session/comparison.h"
#include "drape/session/recording.h"
#include "drape/session/start.h"
#include "drape/session/tour.h"
#include "outcome.h"
#include "window.h"

namespace drape {

namespace {

// Kept in the range of the setting
command::Set set_speed(double speed) {
    const Range range = find_setting("view.speed").range;
    return {"view.speed=" + real_text(std::clamp(speed, range.low, range.high), 4)};
}

}  // namespace

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
    const double longest = session_.simulation().longest_step(), step = session_.simulation().settings().solver.dt;
    if (!(longest > 0) || !std::isfinite(longest) || step <= 0.9 * longest) return {command::Reset{}};
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
    for (const char* topic : {"dropped", "crossing", "ball", "repeat"}) notices_.remove(topic);
    scene_clock_ = {};
    unshown_.reset();  // a picture of what was before
}

}  // namespace drape
