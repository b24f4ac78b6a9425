#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <iterator>

namespace drape {

/// When each step of a run began, where the time step changes on the way: one entry for each change.
class StepTimes {
public:
    /// A new step is made, of this length; 0 while a run that has diverged stands still [s]. Steps come in order, from
    /// 0.
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

private:
    struct Change {
        std::int64_t step;  ///< the first of its length
        double time;        ///< at which that one began [s]
        double dt;          ///< [s]
    };
    std::deque<Change> changes_;
};

}  // namespace drape
