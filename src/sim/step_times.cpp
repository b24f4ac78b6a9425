#include "drape/sim/step_times.h"

#include <algorithm>
#include <iterator>

namespace drape {

void StepTimes::pass(std::int64_t step, double dt) {
    if (changes_.empty() || changes_.back().dt != dt) changes_.push_back({step, at(step), dt});
}

void StepTimes::forget_from(std::int64_t step) {
    while (changes_.size() > 1 && changes_.back().step >= step) changes_.pop_back();
}

void StepTimes::forget_before(std::int64_t step) {
    while (changes_.size() > 1 && changes_[1].step <= step) changes_.pop_front();
}

double StepTimes::at(std::int64_t step) const {
    if (changes_.empty()) return 0;
    const auto after = std::ranges::upper_bound(changes_, step, {}, &Change::step);
    const Change& change = after == changes_.begin() ? *after : *std::prev(after);
    return change.time + static_cast<double>(step - change.step) * change.dt;
}

}  // namespace drape
