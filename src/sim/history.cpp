#include "drape/sim/history.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "drape/sim/memory.h"

namespace drape {
namespace {

/// Between two moments, as watched [s]: at least and at most. What lies between is computed again on the way back.
constexpr double nearest = 0.25, farthest = 1;

/// The part of the memory that moments on the way forth may take; the rest is for those on the way back.
constexpr double share = 0.75;

double bytes_of(const Simulation& simulation, const std::optional<Comparison>& comparison) {
    return moment_bytes(simulation) + (comparison ? moment_bytes(comparison->other()) : 0);
}

}  // namespace

void History::pass(std::int64_t step, std::size_t next_entry, double length, const Simulation& simulation,
                   const std::optional<Comparison>& comparison) {
    watched_ += length;
    const double bytes = bytes_of(simulation, comparison);
    const double room = share * limits_.bytes;
    const double gaps = std::floor(room / bytes) - 1;
    if (gaps < 1) return;  // not even two would fit
    const double apart = std::clamp(limits_.seconds / gaps, nearest, farthest);
    if (!moments_.empty() && watched_ < moments_.back().watched + apart) return;
    forget_between();
    keep(moments_.end(), {step, next_entry, watched_, bytes, false, simulation, comparison});
    while (bytes_ > room) drop_oldest();
    while (moments_.size() > 2 && moments_[1].watched < watched_ - limits_.seconds) drop_oldest();
}

/// Those half way, three quarters of the way and so on: each further step back begins at the last of these.
void History::pass_again(std::int64_t step, std::size_t next_entry, std::int64_t target, const Simulation& simulation,
                         const std::optional<Comparison>& comparison) {
    const Moment* last = before(step);
    if (last == nullptr || last->step == step || 2 * (step - last->step) < target - last->step) return;
    const double bytes = bytes_of(simulation, comparison);
    if (bytes_ + bytes > limits_.bytes) return;
    const auto place = std::ranges::upper_bound(moments_, step, {}, &Moment::step);
    keep(place, {step, next_entry, last->watched, bytes, true, simulation, comparison});
}

void History::keep(std::deque<Moment>::iterator place, Moment moment) {
    bytes_ += moment.bytes;
    moments_.insert(place, std::move(moment));
}

void History::drop_oldest() {
    bytes_ -= moments_.front().bytes;
    moments_.pop_front();
}

void History::forget_between() {
    for (const Moment& moment : moments_) {
        if (moment.between) bytes_ -= moment.bytes;
    }
    std::erase_if(moments_, [](const Moment& moment) { return moment.between; });
}

void History::forget_after(std::int64_t step) {
    forget_between();
    while (!moments_.empty() && moments_.back().step > step) {
        bytes_ -= moments_.back().bytes;
        moments_.pop_back();
    }
    if (!moments_.empty()) watched_ = moments_.back().watched;
}

void History::forget() {
    moments_.clear();
    bytes_ = 0;
}

const History::Moment* History::before(std::int64_t step) const {
    const auto after = std::ranges::upper_bound(moments_, step, {}, &Moment::step);
    return after == moments_.begin() ? nullptr : &*std::prev(after);
}

}  // namespace drape
