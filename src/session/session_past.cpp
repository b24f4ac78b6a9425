// The past that is kept, the way to a step of it, and what replays a recording.

#include <cmath>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/session/session.h"

namespace drape {

void Session::replay(Recording recording) {
    leave_replay();
    replay_ = std::move(recording);
    replay_notice_.clear();
    replay_differs_ = false;
    replay_from_ = steps_made_;
    replay_from_time_ = step_times_.at(steps_made_);
    std::vector<RecordedEntry> entries = std::exchange(replay_.entries, {});
    last_step_ = steps_made_ + replay_.last_step.value_or(entries.empty() ? 0 : entries.back().step);
    for (RecordedEntry& entry : entries) log_.push_back(std::move(entry)), log_.back().step += steps_made_;
    play_due_entries(true);
    if (next_entry_ == end_of_log()) say_cut();
}

void Session::pass_moment(bool begins) {
    const double length = dt() / simulation_.settings().view.speed;
    history_->pass(steps_made_, next_entry_, length, simulation_, comparison_, begins);
    const std::size_t first = history_->empty() ? next_entry_ : history_->first().next_entry;
    for (; first_entry_ < first; ++first_entry_) log_.pop_front();
    step_times_.forget_before(history_->empty() ? steps_made_ : history_->first().step);
}

/// Makes what is left of the way to a step.
void Session::arrive() {
    while (target_ && steps_made_ < *target_) step();
    target_.reset();
}

bool Session::is_redundant_release(const Command& command) const {
    const auto* steer = std::get_if<command::Steer>(&command);
    const bool lets_go = std::holds_alternative<command::Release>(command) || (steer && steer->direction.isZero(0));
    return lets_go && std::ranges::none_of(simulation_.commands_to_let_go(),
                                           [&](const Command& needed) { return needed.index() == command.index(); });
}

void Session::take_over() {
    const double seconds = timeline().back;
    std::string notice = last_step_ > newest_ || steps_made_ >= newest_
                             ? "You take over from the replay before step " + std::to_string(steps_made_)
                             : "You go on from here: the " + real_text(seconds, 3) + " s that came after are forgotten";
    if (recorder_ && !recorder_->cut_after(steps_made_)) {
        std::exchange(recorder_, nullptr)->close(newest_);
        notice += "; the recording cannot be cut back, and ends with them";
    }
    news_.push_back({News::Topic::Takeover, std::move(notice)});
    log_.resize(next_entry_ - first_entry_);
    newest_ = last_step_ = steps_made_;
    step_times_.forget_from(steps_made_);
    idle_from_.reset();
    if (history_) history_->forget_after(steps_made_);
    for (const Command& command : simulation_.commands_to_let_go()) send(command);
}

void Session::go_to(std::int64_t step) {
    simulation_.apply(command::Step{0});  // pauses
    if (!history_ || history_->empty()) return;
    if (!any_lies_ahead()) {
        for (const Command& command : simulation_.commands_to_let_go()) send(command);
    }
    const Timeline timeline = this->timeline();
    if (step != timeline.start) step = std::clamp(step, timeline.oldest, timeline.newest);
    const History::Moment& moment = *history_->before(step);
    if (step < steps_made_ || moment.step > steps_made_) {
        simulation_.go_to(moment.simulation);
        if (comparison_ && moment.comparison) comparison_ = moment.comparison;
        steps_made_ = moment.step;
        next_entry_ = moment.next_entry;
        play_due_entries(false);
    }
    target_ = step;
    behind_ = 0;
}

Timeline Session::timeline() const {
    const bool has_past = history_ && !history_->empty();
    const std::int64_t newest = last_step_ > newest_ ? last_step_ : idle_from_.value_or(newest_);
    const bool is_in_gap = has_past && steps_made_ < history_->oldest().step;
    const std::int64_t oldest = is_in_gap ? history_->first().step : has_past ? history_->oldest().step : steps_made_;
    const std::int64_t now = target_.value_or(std::min(steps_made_, newest));
    return {.start = has_past ? history_->start(steps_made_).step : steps_made_,
            .oldest = oldest,
            .now = now,
            .newest = newest,
            .passed = time_of(now) - replay_from_time_,
            .back = time_of(newest) - time_of(now),
            .kept = time_of(newest) - time_of(oldest),
            .bytes = has_past ? history_->bytes() : 0,
            .replay = last_step_ > newest_,
            .replay_from = replay_from_,
            .is_computed = !target_ || *target_ == steps_made_};
}

/// Steps that are still to be made count as if they were as long as now.
double Session::time_of(std::int64_t step) const {
    return step_times_.at(std::min(step, newest_)) +
           static_cast<double>(std::max(step - newest_, std::int64_t{0})) * dt();
}

std::int64_t Session::step_before_newest(double seconds) const {
    const std::int64_t newest = timeline().newest;
    const double ahead = time_of(newest) - seconds - time_of(newest_);
    if (ahead > 0) return newest_ + std::llround(ahead / dt());
    return seconds > 0 ? step_times_.nearest(time_of(newest_) + ahead) : newest;
}

void Session::leave_replay() {
    arrive();
    if (any_lies_ahead()) take_over();
}

void Session::play_due_entries(bool is_new) {
    if (next_entry_ == end_of_log()) return;
    while (next_entry_ < end_of_log() && log_[next_entry_ - first_entry_].step <= steps_made_) {
        const RecordedEntry entry = log_[next_entry_++ - first_entry_];
        play(entry, is_new);
    }
    if (next_entry_ == end_of_log()) say_cut();
}

void Session::play(const RecordedEntry& entry, bool is_new) {
    if (const auto* hash = std::get_if<std::uint64_t>(&entry.content)) {
        if (*hash != simulation_.hash()) differ("first seen before step " + std::to_string(entry.step - replay_from_));
        return;
    }
    const Command& command = std::get<Command>(entry.content);
    // Who goes back sees as now, and pauses as now
    if (!is_new && !changes_motion(command)) return;
    if (target_ && pauses(command)) {
        if (recorder_) recorder_->write(steps_made_, command);
        return;
    }
    try {
        carry_out(command, is_new);
    } catch (const InputError& error) {
        // It was carried out when it was recorded
        differ(replay_.file + ":" + std::to_string(entry.line) + ": '" + shortened(command_text(command)) +
               "' is refused: " + error.what());
        return;
    }
    if (is_new) begin_run(command);
    const bool is_seen = !changes_state(command) || begins_again(command);
    if (is_new && is_seen) view_commands_.push_back(command);
}

void Session::differ(const std::string& how) {
    replay_differs_ = true;
    if (replay_notice_.empty()) replay_notice_ = one_line("the replay differs from its recording: " + how);
}

void Session::say_cut() {
    if (replay_.notice.empty()) return;
    replay_notice_ += (replay_notice_.empty() ? "" : "; ") + std::exchange(replay_.notice, {});
}

bool Session::run_replay(const std::function<bool()>& stop) {
    while (steps_made_ < last_step_) {
        if (stop && stop()) return false;
        step();
    }
    return true;
}

}  // namespace drape
