#include "drape/session/history.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "drape/scene/memory.h"

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
    constexpr double bytes_of_particle = 500;  // states, those before, and its part of the hierarchy
    double bytes = sizeof(Simulation);
    for (const Cloth& cloth : simulation.cloths()) {
        const Grid& grid = cloth.model.grid;
        bytes += bytes_of_particle * grid.particles() + bytes_of_pairs(simulation.settings().contact, grid);
    }
    // Those of now, and those that a warm start goes on from
    return bytes + 2 * static_cast<double>(simulation.contacts().size() * sizeof(ContactRow));
}

void History::pass(std::int64_t step, std::size_t next_entry, double length, const Simulation& simulation,
                   const std::optional<Comparison>& comparison) {
    watched_ += length;
    const double added = bytes_of(simulation, comparison);
    const double room = share * limits_.bytes;
    const double gaps = std::floor(room / added) - 1;
    if (gaps < 1) return;  // not even two would fit
    const double apart = std::clamp(limits_.seconds / gaps, nearest, farthest);
    if (!moments_.empty() && watched_ < moments_.back().watched + apart) return;
    forget_between();
    moments_.push_back({step, next_entry, watched_, added, false, simulation, comparison});
    while (bytes() > room) moments_.pop_front();
    while (moments_.size() > 2 && moments_[1].watched < watched_ - limits_.seconds) moments_.pop_front();
}

/// Those half way, three quarters of the way and so on: each further step back begins at the last of these.
void History::pass_again(std::int64_t step, std::size_t next_entry, std::int64_t target, const Simulation& simulation,
                         const std::optional<Comparison>& comparison) {
    const Moment* last = before(step);
    if (last == nullptr || last->step == step || 2 * (step - last->step) < target - last->step) return;
    const double added = bytes_of(simulation, comparison);
    if (bytes() + added > limits_.bytes) return;
    const auto place = std::ranges::upper_bound(moments_, step, {}, &Moment::step);
    moments_.insert(place, {step, next_entry, last->watched, added, true, simulation, comparison});
}

void History::forget_after(std::int64_t step) {
    forget_between();
    while (!moments_.empty() && moments_.back().step > step) moments_.pop_back();
    if (!moments_.empty()) watched_ = moments_.back().watched;
}

double History::bytes() const {
    double sum = 0;
    for (const Moment& moment : moments_) sum += moment.bytes;
    return sum;
}

const History::Moment* History::before(std::int64_t step) const {
    const auto after = std::ranges::upper_bound(moments_, step, {}, &Moment::step);
    return after == moments_.begin() ? nullptr : &*std::prev(after);
}

}  // namespace drape
