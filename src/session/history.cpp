#include "drape/session/history.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

double moment_bytes(const Simulation& simulation) {
    // As measured: a particle takes 220 to 280 in the shipped scenes, with its states and its part of the hierarchy,
    // and 1100 with the largest hierarchy; a pair of cloth that is listed takes 45 to 105
    constexpr double bytes_of_particle = 350, bytes_of_listed = 80;
    double bytes = sizeof(Simulation) + bytes_of_listed * static_cast<double>(simulation.report().listed_pairs);
    for (const Cloth& cloth : simulation.cloths()) bytes += bytes_of_particle * cloth.model.grid.particles();
    // Those of now, and those that a warm start goes on from
    return bytes + 2 * static_cast<double>(simulation.contacts().size() * sizeof(ContactRow));
}

void History::pass(std::int64_t step, std::size_t next_entry, double length, const Simulation& simulation,
                   const std::optional<Comparison>& comparison, bool begins) {
    const bool sleeps = simulation.report().asleep && !comparison;
    if (!sleeps) watched_ += length;
    since_last_ += length;
    const double added = bytes_of(simulation, comparison);
    const double room = share * limits_.bytes;
    const double gaps = std::floor(room / added) - 1;
    if (gaps < 1) return;  // not even two would fit
    const double apart = std::clamp(limits_.seconds / std::max(gaps - 1, 1.0), nearest, farthest);  // one is the start
    if (!begins && !moments_.empty() && since_last_ < apart) return;
    forget_between();
    since_last_ = 0;
    if (begins && !moments_.empty() && moments_.back().step == step) moments_.pop_back();
    if (sleeps && !begins && std::ranges::count(moments_, watched_, &Moment::watched) > 1) moments_.pop_back();
    // Of two, the start is forgotten too: else there would be no way back
    moments_.push_back({step, next_entry, watched_, added, false, begins && gaps >= 2, simulation, comparison});
    while (moments_.size() > 2 && bytes() > room) forget_oldest();
    const auto next = [&] { return moments_[keeps_first() ? 2 : 1].watched; };
    while (moments_.size() > 3 && next() < watched_ - limits_.seconds) forget_oldest();
}

/// It is where the run begins of which the next moment is.
bool History::keeps_first() const { return moments_.front().begins && !moments_[1].begins; }

void History::forget_oldest() {
    has_gap_ = keeps_first();
    moments_.erase(moments_.begin() + (has_gap_ ? 1 : 0));
}

/// Those half way, three quarters of the way and so on: each further step back begins at the last of these.
void History::pass_again(std::int64_t step, std::size_t next_entry, std::int64_t target, const Simulation& simulation,
                         const std::optional<Comparison>& comparison) {
    const Moment* last = before(step);
    if (last == nullptr || last->step == step || 2 * (step - last->step) < target - last->step) return;
    const double added = bytes_of(simulation, comparison);
    if (bytes() + added > limits_.bytes) return;
    const auto place = std::ranges::upper_bound(moments_, step, {}, &Moment::step);
    moments_.insert(place, {step, next_entry, last->watched, added, true, false, simulation, comparison});
}

void History::forget_after(std::int64_t step) {
    forget_between();
    while (!moments_.empty() && moments_.back().step > step) moments_.pop_back();
    has_gap_ = has_gap_ && moments_.size() > 1;
    if (!moments_.empty()) watched_ = moments_.back().watched;
    since_last_ = 0;
}

double History::bytes() const {
    double sum = 0;
    for (const Moment& moment : moments_) sum += moment.bytes;
    return sum;
}

const History::Moment& History::oldest() const {
    if (!has_gap_) return moments_.front();
    return *std::find_if(std::next(moments_.begin()), moments_.end(), [](const Moment& one) { return !one.between; });
}

const History::Moment& History::start(std::int64_t step) const {
    const Moment* found = &moments_.front();
    for (const Moment& moment : moments_) {
        if (moment.begins && moment.step <= step) found = &moment;
    }
    return *found;
}

const History::Moment* History::before(std::int64_t step) const {
    const auto after = std::ranges::upper_bound(moments_, step, {}, &Moment::step);
    return after == moments_.begin() ? nullptr : &*std::prev(after);
}

}  // namespace drape
