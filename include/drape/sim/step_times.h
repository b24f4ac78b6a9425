#pragma once

#include <cstdint>
#include <deque>

namespace drape {

/// When each step of a run began, where the time step changes on the way: one entry for each change.
class StepTimes {
public:
    /// A new step is made, of this length; 0 while a run that has diverged stands still [s]. Steps come in order, from
    /// 0.
    void pass(std::int64_t step, double dt);

    /// The run goes on from here in another way: forgets the steps from this one on.
    void forget_from(std::int64_t step);

    /// Nobody asks for steps before this one any more. Times stay as they are.
    void forget_before(std::int64_t step);

    /// The simulated time from the first step of all to the beginning of this one [s]. Steps that are not made yet
    /// count as long as the last.
    [[nodiscard]] double at(std::int64_t step) const;

private:
    struct Change {
        std::int64_t step;  ///< the first of its length
        double time;        ///< at which that one began [s]
        double dt;          ///< [s]
    };
    std::deque<Change> changes_;
};

}  // namespace drape
