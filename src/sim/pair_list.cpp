#include "drape/sim/pair_list.h"

#include <algorithm>
#include <numeric>

namespace drape {
namespace {

/// Pairs of leaves that a thread takes at once: where cloth is folded, some that follow each other have
/// much in them, and those after them nothing.
constexpr std::size_t leaves_a_thread = 16;

}  // namespace

void PairList::clear() {
    for (Part& part : parts_) part.near.clear();
    size_ = 0;
    list_.clear();
}

void PairList::add(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves) {
    workers_.run(leaves.size() / leaves_a_thread, [&](int part, int parts) {
        const auto p = static_cast<std::size_t>(part), step = leaves_a_thread * static_cast<std::size_t>(parts);
        for (std::size_t k = leaves_a_thread * p; k < leaves.size(); k += step) {
            const auto some = leaves.subspan(k, std::min(leaves_a_thread, leaves.size() - k));
            find_near_pairs(first, second, some, parts_[p].near);
        }
    });
    size_ = 0;
    for (const Part& part : parts_) size_ += part.near.size();
}

/// Brings the list into the order of a number of each pair; pairs with the same number stay in the order they had.
/// @param numbers that there are
template <class Number>
void PairList::sort_by(std::size_t numbers, Number number_of) {
    places_.assign(numbers + 1, 0);
    for (const Listed& pair : list_) ++places_[number_of(pair.features) + 1];
    std::partial_sum(places_.begin(), places_.end(), places_.begin());
    other_list_.resize(list_.size());
    for (const Listed& pair : list_) other_list_[places_[number_of(pair.features)]++] = pair;
    list_.swap(other_list_);
}

/// By what comes last in the order of features first: their first particles, then their cloths and kind. That leaves
/// few pairs that are alike in all these, to be sorted by their other particles.
void PairList::close() {
    int particles = 0, cloths = 0;
    for (Part& part : parts_) {
        for (const NearPair& pair : part.near) {
            list_.push_back({pair.features, pair.triangle, pair.distance});
            particles = std::max(particles, pair.features.particles[0] + 1);
            cloths = std::max({cloths, pair.features.cloths[0] + 1, pair.features.cloths[1] + 1});
        }
        part.near.clear();
    }
    const auto kind_of = [&](const FeaturePair& pair) {
        return static_cast<std::size_t>((pair.cloths[0] * cloths + pair.cloths[1]) * 2 + pair.first_count - 1);
    };
    sort_by(static_cast<std::size_t>(particles),
            [](const FeaturePair& pair) { return static_cast<std::size_t>(pair.particles[0]); });
    sort_by(static_cast<std::size_t>(2 * cloths * cloths), kind_of);
    const auto are_alike = [&](const Listed& one, const Listed& two) {
        return one.features.particles[0] == two.features.particles[0] && kind_of(one.features) == kind_of(two.features);
    };
    for (auto begin = list_.begin(); begin != list_.end();) {
        const auto end =
            std::find_if_not(begin, list_.end(), [&](const Listed& pair) { return are_alike(*begin, pair); });
        std::sort(begin, end,
                  [](const Listed& one, const Listed& two) { return one.features.particles < two.features.particles; });
        begin = end;
    }
}

}  // namespace drape
