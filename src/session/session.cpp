#include "drape/session/session.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "drape/base/input_error.h"
#include "drape/base/stopwatch.h"

namespace drape {
namespace {

/// The most simulated time that one call of `advance` makes up for [s]: after a stall the rest is dropped.
constexpr double longest_frame = 0.25;

/// Steps between two hashes of a recording.
constexpr std::int64_t hash_interval = 500;

/// A multiple of dt that rounding has put this far (in steps) beyond the time still counts.
constexpr double step_tolerance = 1e-6;

/// Likewise of a late time, whose own rounding is more than that.
constexpr double clock_tolerance = 4 * std::numeric_limits<double>::epsilon();

}  // namespace

Session::Session(Simulation simulation) : simulation_(std::move(simulation)), start_time_(simulation_.report().time) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Session::~Session() {
    try {
        close();
    } catch (const RunError&) {
        // Whoever wants to know calls close
    }
}

void Session::record(const std::string& file, const std::vector<std::string>& assignments,
                     const std::string& snapshot) {
    recorder_ = std::make_unique<Recorder>(file, simulation_.scene(), assignments);
    if (!snapshot.empty()) recorder_->write(0, command::Load{snapshot});
}

bool Session::save_recording(const std::filesystem::path& file) const {
    if (!recorder_) throw RunError("the recording has ended: it could not be cut back");
    return recorder_->save(file, newest_);
}

void Session::keep_history(HistoryLimits limits) {
    history_.emplace(limits);
    pass_moment(true);
}

void Session::send(const Command& command) {
    if (changes_motion(command) || std::holds_alternative<command::Step>(command)) arrive();
    // A command that is refused takes nothing over, nor does one that lets go of nothing
    if (any_lies_ahead() && changes_motion(command)) {
        if (is_redundant_release(command)) return;
        Simulation trial = simulation_;
        if (const auto* begun = std::get_if<command::Compare>(&command)) Comparison(trial, begun->assignments);
        trial.apply(command);
        take_over();
    }
    const bool is_new = steps_made_ >= newest_;
    carry_out(command, is_new);
    if (!is_new && recorder_ && !pauses(command)) recorder_->write(newest_, command);  // what is seen, in its order
    if (!history_) return;
    if (changes_motion(command)) {
        log_.push_back({steps_made_, command});
        next_entry_ = end_of_log();
    }
    begin_run(command);
}

void Session::carry_out(const Command& command, bool is_new) {
    if (const auto* begun = std::get_if<command::Compare>(&command)) {
        compare(*begun);
    } else {
        simulation_.apply(command);
        if (changes_scene(command)) comparison_.reset();
        compare_after(command);
    }
    if (std::holds_alternative<command::Load>(command) && clock_steps_ == 0) {
        start_time_ = simulation_.report().time;
    }
    if (is_new && begins_again(command)) {
        dropped_ = 0;
        std::erase_if(news_, [](const News& news) { return news.topic == News::Topic::Crossing; });
    }
    if (is_new && recorder_) recorder_->write(steps_made_, command);
}

/// There is no way back from here, but from a reset.
void Session::begin_run(const Command& command) {
    if (!history_ || !begins_again(command)) return;
    if (!std::holds_alternative<command::Reset>(command)) {
        history_->forget();
        idle_from_.reset();
    }
    pass_moment(true);
}

void Session::compare_after(const Command& command) {
    if (!comparison_) return;
    try {
        comparison_->apply(command, simulation_);
    } catch (const std::runtime_error& error) {
        comparison_.reset();
        news_.push_back({News::Topic::Takeover, one_line(std::string("The comparison has ended: ") + error.what())});
    }
}

FrameView Session::view() {
    FrameView view = simulation_.view(blend());
    if (swings()) {
        swing_->show(view);
        return view;
    }
    if (!comparison_) return view;
    compared_ = comparison_->view(simulation_);
    view.comparison = &compared_;
    return view;
}

void Session::compare(const command::Compare& command) {
    if (!command.begins() && !comparison_) return;
    std::optional<Comparison> begun;
    if (command.begins()) {
        Simulation first = simulation_;
        first.apply(command);
        begun.emplace(first, command.assignments);  // throws before anything is changed
    }
    simulation_.apply(command);
    comparison_ = std::move(begun);
    simulation_.apply(command::Set{comparison_ ? "view.colour=difference" : "view.colour=plain"});
}

/// From the last moment of this run that is kept and calm, or from its start.
void Session::start_swing() {
    const std::int64_t steps_before = steps_made_ - simulation_.report().step;
    const History::Moment* moment = history_->before(steps_made_);
    while (moment != nullptr && !is_calm(moment->simulation)) moment = history_->before(moment->step - 1);
    const bool is_of_this_run = moment != nullptr && moment->step - moment->simulation.report().step == steps_before &&
                                same_start(moment->simulation.settings(), simulation_.settings());
    Simulation before = is_of_this_run ? moment->simulation : simulation_;
    if (!is_of_this_run) before.apply(command::Reset{});
    if (auto mode = find_unstable_mode(simulation_, before)) swing_.emplace(std::move(*mode), std::move(before));
}

void Session::step() {
    const bool is_new = steps_made_ >= newest_, was_over = simulation_.report().status != Status::Ok;
    if (is_new) step_times_.pass(steps_made_, was_over || sleeps() ? 0 : dt());
    if (is_new && recorder_) recorder_->begin_step(steps_made_);
    const std::int64_t dangers = simulation_.report().crossing.starts;
    simulation_.step();
    if (!was_over) swing_.reset();
    if (is_new && simulation_.report().crossing.starts > dangers) {
        news_.push_back({News::Topic::Crossing, simulation_.crossing_warning()});
    }
    if (comparison_) comparison_->follow(simulation_);
    if (history_ && !was_over && simulation_.report().status == Status::Diverged) start_swing();
    ++steps_made_;
    if (is_new && recorder_ && steps_made_ % hash_interval == 0) {
        recorder_->write_hash(steps_made_, simulation_.hash());
    }
    if (is_new) {
        newest_ = steps_made_;
        if (!was_over) idle_from_.reset();
        if (was_over && !idle_from_) idle_from_ = steps_made_ - 1;
    }
    play_due_entries(is_new);
    if (!history_ || was_over) return;
    if (is_new) {
        pass_moment();
    } else if (target_) {
        history_->pass_again(steps_made_, next_entry_, *target_, simulation_, comparison_);
    }
}

void Session::advance(double elapsed, double budget) {
    const Stopwatch watch;
    if (swings()) swing_->pass(elapsed);
    if (target_) {
        while (steps_made_ < *target_ && watch.seconds() < budget) step();
        if (steps_made_ >= *target_) target_.reset();
        return;
    }
    if (simulation_.paused()) {
        while (simulation_.paused() && simulation_.steps_wanted() > 0 && watch.seconds() < budget) step();
        return;
    }
    const double speed = simulation_.settings().view.speed, longest = longest_frame * speed;
    behind_ += std::max(0.0, elapsed) * speed;
    const double kept = std::min(behind_, std::max(longest, dt()));
    dropped_ += behind_ - kept;
    behind_ = kept;
    while (!simulation_.paused() && behind_ >= dt()) {
        // Nobody watches once more how it slept
        const bool slept = steps_made_ < newest_ && sleeps();
        if (!slept) behind_ -= dt();
        step();
        if (watch.seconds() < budget || behind_ < dt()) continue;

        // The machine cannot keep up: what is left of whole steps is dropped
        const double rest = std::fmod(behind_, dt());
        if (!slept) dropped_ += behind_ - rest;
        behind_ = rest;
    }
}

double Session::steps_to(double time) const {
    const double steps = (time - this->time()) / dt(), whole = std::round(steps);
    return std::abs(steps - whole) <= std::max(step_tolerance, clock_tolerance * time / dt()) ? whole : steps;
}

bool Session::run_until(double time, const std::function<bool()>& stop) {
    bool stopped = false;
    for (;;) {
        clock_.pass(clock_steps_, dt());
        const double next = start_time_ + clock_.at(clock_steps_ + 1);
        if (next > time + std::max(step_tolerance * dt(), clock_tolerance * time)) break;
        stopped = stop && stop();
        if (stopped) break;
        ++clock_steps_;
        step();
    }
    behind_ = std::max(0.0, time - this->time());
    return !stopped;
}

Real Session::blend() const {
    return simulation_.paused() ? Real(1) : static_cast<Real>(std::clamp(behind_ / dt(), 0.0, 1.0));
}

std::string Session::record_notice() const {
    if (!recorder_ || recorder_->set_aside().empty()) return {};
    return "found the recording of an unfinished run; moved to " + recorder_->set_aside().string();
}

void Session::close() {
    if (!recorder_ || !recorder_->has_file()) return;
    // The last state is that of the recording, wherever the user has looked
    if (steps_made_ < newest_) {
        go_to(newest_);
        target_ = newest_;
        arrive();
    }
    const auto recorder = std::exchange(recorder_, nullptr);
    recorder->write_hash(steps_made_, simulation_.hash());
    recorder->close(steps_made_);
}

}  // namespace drape
