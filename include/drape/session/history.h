#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>

#include "drape/session/comparison.h"
#include "drape/sim/simulation.h"

namespace drape {

/// When each step of a run began, where the time step changes on the way: one entry for each change.
class StepTimes {
public:
    /// A step is made, of this length; 0 while a run stands still that has diverged or sleeps [s]. Steps come in order,
    /// from 0.
    void pass(std::int64_t step, double dt) {
        if (changes_.empty() || changes_.back().dt != dt) changes_.push_back({step, at(step), dt});
    }

    /// The run goes on from here in another way: forgets the steps from this one on.
    void forget_from(std::int64_t step) {
        while (changes_.size() > 1 && changes_.back().step >= step) changes_.pop_back();
    }

    /// Nobody asks for steps before this one any more. Times stay as they are.
    void forget_before(std::int64_t step) {
        while (changes_.size() > 1 && changes_[1].step <= step) changes_.pop_front();
    }

    /// The simulated time from the first step of all to the beginning of this one [s]. Steps that are not made yet
    /// count as long as the last.
    [[nodiscard]] double at(std::int64_t step) const {
        if (changes_.empty()) return 0;
        const auto after = std::ranges::upper_bound(changes_, step, {}, &Change::step);
        const Change& change = after == changes_.begin() ? *after : *std::prev(after);
        return change.time + static_cast<double>(step - change.step) * change.dt;
    }

    /// The step that begins nearest to a time; of those without a length, one of both ends.
    [[nodiscard]] std::int64_t nearest(double time) const {
        if (changes_.empty()) return 0;
        const auto after = std::ranges::upper_bound(changes_, time, {}, &Change::time);
        const Change& change = after == changes_.begin() ? *after : *std::prev(after);
        return change.step + (change.dt > 0 ? std::llround((time - change.time) / change.dt) : 0);
    }

private:
    struct Change {
        std::int64_t step;  ///< the first of its length
        double time;        ///< at which that one began [s]
        double dt;          ///< [s]
    };
    std::deque<Change> changes_;
};

/// About what a copy of a simulation takes, its integrators not counted [bytes].
double moment_bytes(const Simulation& simulation);

/// How much of the past is kept.
struct HistoryLimits {
    double seconds = 20;   ///< as they were watched: of simulated time, over `view.speed`, without sleep
    double bytes = 256e6;  ///< about, of memory
};

/// Moments of a run, from which a session can go back and make the steps between them again.
class History {
public:
    struct Moment {
        std::int64_t step;       ///< of the session
        std::size_t next_entry;  ///< of the session's log, counted from the first that there ever was
        double watched;          ///< [s]
        double bytes;            ///< about
        bool between;            ///< made on the way back, to go further back quickly
        bool begins;             ///< the run
        Simulation simulation;
        std::optional<Comparison> comparison;
    };

    explicit History(HistoryLimits limits) : limits_(limits) {}

    /// Keeps this moment, if it is time for it: of a sleep its beginning and, again and again, its end.
    /// @param next_entry of the log
    /// @param length of a step, as it was watched [s]
    /// @param begins it is the start of a run, which is kept for as long as that goes on
    void pass(std::int64_t step, std::size_t next_entry, double length, const Simulation& simulation,
              const std::optional<Comparison>& comparison, bool begins);

    /// Keeps a moment on the way back to an earlier step, where the moments before it lie far apart.
    /// @param target the step it goes back to
    void pass_again(std::int64_t step, std::size_t next_entry, std::int64_t target, const Simulation& simulation,
                    const std::optional<Comparison>& comparison);

    /// Forgets those on the way back.
    void forget_between() {
        std::erase_if(moments_, [](const Moment& moment) { return moment.between; });
    }

    /// Forgets what came after a step.
    void forget_after(std::int64_t step);

    void forget() {
        moments_.clear();
        has_gap_ = false;
    }

    /// The last moment that is not after a step; null: there is none
    [[nodiscard]] const Moment* before(std::int64_t step) const;

    [[nodiscard]] bool empty() const { return moments_.empty(); }

    /// The first one of all. @pre there are any
    [[nodiscard]] const Moment& first() const { return moments_.front(); }

    /// The first one from which on all of the time is kept. @pre there are any
    [[nodiscard]] const Moment& oldest() const;

    /// Where the run of a step has begun; the first one of all where that is forgotten. @pre there are any
    [[nodiscard]] const Moment& start(std::int64_t step) const;

    /// About, of memory.
    [[nodiscard]] double bytes() const;

private:
    [[nodiscard]] bool keeps_first() const;
    void forget_oldest();

    HistoryLimits limits_;
    std::deque<Moment> moments_;  ///< by their steps
    bool has_gap_ = false;        ///< after the first, which begins the run
    double watched_ = 0;          ///< until the newest step, without sleep [s]
    double since_last_ = 0;       ///< moment on the way forth, sleep included [s]
};

}  // namespace drape
