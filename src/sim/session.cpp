#include "drape/sim/session.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

Session::Session(Simulation simulation)
    : simulation_(std::move(simulation)), start_time_(simulation_.report().time), time_(start_time_) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Session::~Session() {
    try {
        close();
    } catch (const RunError&) {
        // Whoever wants to know calls close
    }
}

void Session::record(const std::string& file, const std::vector<std::string>& assignments) {
    recorder_ = std::make_unique<Recorder>(file, simulation_.scene(), assignments);
}

void Session::replay(Recording recording) {
    replay_ = std::move(recording);
    next_entry_ = 0;
    if (replay_.entries.empty()) say_cut();
    play_due_entries();
}

void Session::send(const Command& command) {
    simulation_.apply(command);
    if (recorder_) recorder_->write(steps_made_, command);
}

void Session::play_due_entries() {
    if (next_entry_ == replay_.entries.size()) return;
    while (next_entry_ < replay_.entries.size() && replay_.entries[next_entry_].step <= steps_made_) {
        play(replay_.entries[next_entry_++]);
    }
    if (next_entry_ == replay_.entries.size()) say_cut();
}

void Session::play(const RecordedEntry& entry) {
    if (const auto* hash = std::get_if<std::uint64_t>(&entry.content)) {
        if (*hash != simulation_.hash()) differ("first seen before step " + std::to_string(entry.step));
        return;
    }
    const Command& command = std::get<Command>(entry.content);
    try {
        send(command);
    } catch (const InputError& error) {
        // It was carried out when it was recorded
        differ(replay_.file + ":" + std::to_string(entry.line) + ": '" + shortened(command_text(command)) +
               "' is refused: " + error.what());
        return;
    }
    view_commands_.push_back(command);
}

void Session::differ(const std::string& how) {
    replay_differs_ = true;
    if (replay_notice_.empty()) replay_notice_ = one_line("the replay differs from its recording: " + how);
}

void Session::say_cut() {
    if (replay_.notice.empty()) return;
    replay_notice_ += (replay_notice_.empty() ? "" : "; ") + replay_.notice;
}

void Session::step() {
    simulation_.step();
    ++steps_made_;
    if (recorder_ && steps_made_ % hash_interval == 0) recorder_->write_hash(steps_made_, simulation_.hash());
    play_due_entries();
}

void Session::advance(double elapsed, double budget) {
    const Stopwatch watch;
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
        behind_ -= dt();
        step();
        if (watch.seconds() < budget || behind_ < dt()) continue;

        // The machine cannot keep up: what is left of whole steps is dropped
        const double rest = std::fmod(behind_, dt());
        dropped_ += behind_ - rest;
        behind_ = rest;
    }
}

double Session::time_after_next_step() {
    if (dt() != counted_dt_) {
        counted_from_ = time_;
        counted_steps_ = 0;
        counted_dt_ = dt();
    }
    return counted_from_ + static_cast<double>(counted_steps_ + 1) * counted_dt_;
}

bool Session::run_until(double time, const std::function<bool()>& stop) {
    bool stopped = false;
    for (;;) {
        const double next = time_after_next_step();
        if (next > time + std::max(step_tolerance * dt(), clock_tolerance * time)) break;
        stopped = stop && stop();
        if (stopped) break;
        time_ = next;
        ++counted_steps_;
        step();
    }
    behind_ = std::max(0.0, time - time_);
    return !stopped;
}

bool Session::run_replay(const std::function<bool()>& stop) {
    const std::int64_t last_whole = replay_.entries.empty() ? 0 : replay_.entries.back().step;
    const std::int64_t end = replay_.last_step.value_or(last_whole);
    while (steps_made_ < end) {
        if (stop && stop()) return false;
        step();
    }
    return true;
}

std::vector<Command> Session::take_view_commands() { return std::exchange(view_commands_, {}); }

Real Session::blend() const {
    return simulation_.paused() ? Real(1) : static_cast<Real>(std::clamp(behind_ / dt(), 0.0, 1.0));
}

double Session::dt() const { return simulation_.settings().solver.dt; }

std::string Session::record_notice() const {
    if (!recorder_ || recorder_->set_aside().empty()) return {};
    return "a run that did not end has left a recording: it is " + recorder_->set_aside().string() + " now";
}

void Session::close() {
    if (!recorder_) return;
    const auto recorder = std::exchange(recorder_, nullptr);
    recorder->write_hash(steps_made_, simulation_.hash());
    recorder->close(steps_made_);
}

}  // namespace drape
