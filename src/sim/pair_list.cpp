#include "drape/sim/pair_list.h"

#include <algorithm>

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

void PairList::close() {
    for (Part& part : parts_) {
        for (const NearPair& pair : part.near) list_.push_back({pair.features, pair.triangle, pair.distance});
        part.near.clear();
    }
    std::ranges::sort(list_, {}, &Listed::features);  // each is there once, so that threads do not show
}

}  // namespace drape
