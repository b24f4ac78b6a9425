#include "drape/sim/pair_list.h"

#include <algorithm>
#include <functional>

namespace drape {
namespace {

/// Pairs of leaves that a thread takes at once: where cloth is folded, some that follow each other have much in them,
/// and those after them nothing.
constexpr std::size_t leaves_in_a_block = 16;

}  // namespace

void PairList::clear() {
    for (Part& part : parts_) {
        part.near.clear();
        part.listed.clear();
    }
    size_ = 0;
    list_.clear();
}

void PairList::add(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves) {
    workers_.run(leaves.size() / leaves_in_a_block, [&](int part, int parts) {
        const auto p = static_cast<std::size_t>(part), step = leaves_in_a_block * static_cast<std::size_t>(parts);
        for (std::size_t k = leaves_in_a_block * p; k < leaves.size(); k += step) {
            const auto block = leaves.subspan(k, std::min(leaves_in_a_block, leaves.size() - k));
            find_near_pairs(first, second, block, parts_[p].near);
        }
    });
    size_ = 0;
    for (const Part& part : parts_) size_ += part.near.size();
}

/// Each thread puts its own in order; then whichever of them has the least goes first.
void PairList::close() {
    workers_.run(size_ / worth_a_thread, [&](int part, int parts) {
        for (auto p = static_cast<std::size_t>(part); p < parts_.size(); p += static_cast<std::size_t>(parts)) {
            auto& [near, listed] = parts_[p];
            for (const NearPair& pair : near) listed.push_back({pair.features, pair.triangle, pair.distance});
            near.clear();
            std::ranges::sort(listed, std::greater{}, &Listed::features);
        }
    });
    for (;;) {
        Part* least = nullptr;
        for (Part& part : parts_) {
            if (part.listed.empty()) continue;
            if (!least || part.listed.back().features < least->listed.back().features) least = &part;
        }
        if (!least) return;
        list_.push_back(least->listed.back());
        least->listed.pop_back();
    }
}

}  // namespace drape
