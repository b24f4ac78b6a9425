#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drape/session/comparison.h"
#include "drape/session/history.h"
#include "drape/session/recording.h"
#include "drape/session/unstable_mode.h"
#include "drape/sim/simulation.h"

namespace drape {

/// What happened to a run, for the user.
struct News {
    enum class Topic { Takeover, Crossing } topic;
    std::string text;
};

/// A simulation in time, with its recording or its replay: the one loop that window, capture and lab share. Commands
/// take effect between steps, and a recording keeps the number of the step before which each came.
///
/// All commands that the motion follows from stand in a log, with those of a replay that are still to come. To go back
/// is to take up a moment that was kept and to make the steps from there again with the log's commands, which gives the
/// same bits. While any of the log lies ahead, a command that would change the motion takes over: what lay ahead is
/// forgotten.
class Session {
public:
    explicit Session(Simulation simulation);

    /// Writes every command from now on, and a hash now and then, to a file, or keeps them for `save_recording`.
    /// @param file empty: none
    /// @param assignments that were applied to the scene's settings before the simulation was made
    /// @param snapshot that the simulation was read from; empty: none
    /// @throws RunError if it cannot be written
    void record(const std::string& file, const std::vector<std::string>& assignments, const std::string& snapshot = {});

    /// Writes what was recorded until the newest step as a recording of its own; without a file, since the scene came.
    /// @pre `record` was called
    /// @return false if a file has that name: it stays
    /// @throws RunError if it could not be written whole, or the recording has ended
    [[nodiscard]] bool save_recording(const std::filesystem::path& file) const;

    /// Feeds the commands of a recording as their steps come, from now on. What lies ahead is forgotten.
    void replay(Recording recording);

    /// Keeps moments from now on, to go back to.
    void keep_history(HistoryLimits limits);

    /// Goes to where the run has begun, or to the nearest step of the timeline, and pauses. What has to be computed for
    /// it is computed by `advance`. Nothing happens without a history.
    void go_to(std::int64_t step);

    [[nodiscard]] Timeline timeline() const;

    /// The step so many seconds before the newest, as `Timeline::back` counts them.
    [[nodiscard]] std::int64_t step_before_newest(double seconds) const;

    /// Ends a replay: the run is the user's from here on, and what lay ahead is forgotten.
    void leave_replay();

    /// What there is to tell the user of since the last call: that a command has ended what lay ahead, or a comparison;
    /// and that a danger began that cloth and a ball or a solid pass through each other (`StepReport::crossing`), in a
    /// step that was made for the first time: one that the user goes back to and plays again is not told again,
    /// nor one of a run that has begun again since.
    [[nodiscard]] std::vector<News> take_news() { return std::exchange(news_, {}); }

    /// Carries out a command and records it.
    /// @throws InputError as `Simulation::apply` and `Comparison`, RunError as the latter; it is not recorded then
    void send(const Command& command);

    /// Lets `elapsed` seconds of wall time pass, each of which is `view.speed` simulated ones: makes as many whole
    /// steps as fit, at most 0.25 s worth of them at speed 1, and stops early when they have taken `budget` seconds of
    /// wall time themselves. What is left over stays, what is cut is dropped. Paused, it makes only the steps that were
    /// asked for.
    void advance(double elapsed, double budget);

    /// Makes whole steps for as long as they end no later than `time` [s]; pauses are passed over. It is the scene's
    /// clock, except that a reset in a replay does not set it back.
    /// @param stop asked before each step; empty: none asks
    /// @return false if it said so
    bool run_until(double time, const std::function<bool()>& stop = {});

    /// Makes the steps of the recording that is replayed, to where it was closed, or to its last whole line; pauses are
    /// passed over.
    /// @param stop as for `run_until`
    /// @return false if it said so
    bool run_replay(const std::function<bool()>& stop = {});

    /// The time at which the simulation was when the session began: that of the scene's start file or of a snapshot, or
    /// 0 [s].
    [[nodiscard]] double start_time() const { return start_time_; }

    /// The time that `run_until` has come to, on the same clock [s].
    [[nodiscard]] double time() const { return start_time_ + clock_.at(clock_steps_); }

    /// Steps of the present length from there to a time: a whole number where the time is the end of one but for
    /// rounding, as `run_until` has it.
    [[nodiscard]] double steps_to(double time) const;

    /// Camera commands of a replay that came due since the last call, for whoever owns the camera.
    [[nodiscard]] std::vector<Command> take_view_commands() { return std::exchange(view_commands_, {}); }

    /// Between 0 and 1: how far the present lies beyond the last step.
    [[nodiscard]] Real blend() const;

    /// A run that has diverged because of its step is seen as it was before, swinging in its unstable mode, where a
    /// history is kept and no other run is beside it.
    [[nodiscard]] FrameView view();

    /// Whether it is seen so now: it moves with the wall time that `advance` is told of, paused or not.
    [[nodiscard]] bool swings() const {
        return swing_ && !comparison_ && simulation_.report().status == Status::Diverged;
    }

    /// Whether another run is beside it: from `command::Compare` until the next one, or the next scene.
    [[nodiscard]] bool compares() const { return comparison_.has_value(); }

    [[nodiscard]] Simulation& simulation() { return simulation_; }

    /// Simulated seconds of this run that were cut because the machine could not keep up or stood still; counted
    /// afresh when it begins again.
    [[nodiscard]] double dropped() const { return dropped_; }

    /// What a replay has to say: how it first differed, and that its recording was cut. Empty while all is well.
    [[nodiscard]] const std::string& replay_notice() const { return replay_notice_; }

    /// Whether a hash of the replay was not that of the state, or a command was refused that once was carried out.
    [[nodiscard]] bool replay_differs() const { return replay_differs_; }

    /// What there is to say of the file that is recorded to: that a run that never ended has left one. Else empty.
    [[nodiscard]] std::string record_notice() const;

    /// Writes the closing hash of a recording and closes it; called by the destructor too.
    /// @throws RunError if the file could not be written whole
    void close();

    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

private:
    void step();
    void play_due_entries(bool is_new);
    void play(const RecordedEntry& entry, bool is_new);
    void carry_out(const Command& command, bool is_new);
    void compare(const command::Compare& command);
    void compare_after(const Command& command);
    void take_over();
    void begin_run(const Command& command);
    void pass_moment(bool begins = false);
    void arrive();
    void start_swing();
    [[nodiscard]] bool is_redundant_release(const Command& command) const;
    [[nodiscard]] bool any_lies_ahead() const {
        return next_entry_ < end_of_log() || steps_made_ < std::max(newest_, last_step_);
    }
    [[nodiscard]] std::size_t end_of_log() const { return first_entry_ + log_.size(); }
    void differ(const std::string& how);
    void say_cut();
    [[nodiscard]] bool sleeps() const { return simulation_.report().asleep && !comparison_; }
    [[nodiscard]] double time_of(std::int64_t step) const;
    [[nodiscard]] double dt() const { return simulation_.settings().solver.dt; }

    Simulation simulation_;
    std::unique_ptr<Recorder> recorder_;
    Recording replay_;               ///< but for its entries, which are in the log
    std::deque<RecordedEntry> log_;  ///< of commands that were carried out, or will be
    std::size_t first_entry_ = 0;    ///< the number of the log's first: older ones have been forgotten
    std::size_t next_entry_ = 0;     ///< to be played
    std::optional<History> history_;
    StepTimes step_times_;  ///< of the new steps
    std::optional<Comparison> comparison_;
    ComparisonView compared_;                ///< as it was last viewed
    std::optional<Swing> swing_;             ///< of the run that has diverged last, if its mode was found
    std::int64_t newest_ = 0;                ///< step that was reached
    std::optional<std::int64_t> idle_from_;  ///< step from which on nothing happened: the run had diverged
    std::int64_t last_step_ = 0;             ///< of the recording
    std::optional<std::int64_t> target_;     ///< step on the way to which steps are made again
    std::vector<News> news_;
    std::vector<Command> view_commands_;
    std::string replay_notice_;
    bool replay_differs_ = false;
    std::int64_t replay_from_ = 0;  ///< step
    double replay_from_time_ = 0;   ///< of `step_times_` [s]
    std::int64_t steps_made_ = 0;   ///< by this session; a reset does not set it back, but `go_to` does
    double start_time_;             ///< [s]
    StepTimes clock_;               ///< of the steps that `run_until` made
    std::int64_t clock_steps_ = 0;  ///< how many
    double behind_ = 0;             ///< time passed beyond the last step [s]
    double dropped_ = 0;
};

}  // namespace drape
