#pragma once

#include <span>
#include <vector>

#include "drape/base/workers.h"
#include "drape/contact/near_pairs.h"

namespace drape {

/// The pairs of features that were near each other at some time, made and looked through by some threads. It is in the
/// order of the features, and so is what comes of it: neither depends on how many threads there are.
class PairList {
public:
    /// A pair as it was when the list was made.
    struct Listed {
        FeaturePair features;
        int triangle;
        Real distance;  ///< [m]
    };

    /// @param threads that share the work, at least 1
    void use(int threads) {
        workers_.use(threads);
        parts_.resize(static_cast<std::size_t>(threads));
    }

    /// Begins with none.
    void clear();

    /// Adds what `find_near_pairs` finds in leaves.
    /// @par Cost that of `find_near_pairs`, shared among threads; no allocation once it has been as long before
    void add(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves);

    /// Brings what was added into order. @par Cost O(n log n)
    void close();

    /// Pairs that were added.
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Calls look(listed, near) for each pair of the closed list.
    /// @param look adds to `near` what it takes the pair to be now, or nothing; called by several threads at a time
    /// @param near receives all that, in the order of the list; cleared first
    template <class Look>
    void look_through(std::vector<NearPair>& near, Look look) {
        std::size_t parts_made = 1;
        workers_.run(list_.size() / worth_a_thread, [&](int part, int parts) {
            const auto p = static_cast<std::size_t>(part), count = static_cast<std::size_t>(parts);
            if (part == 0) parts_made = count;
            std::vector<NearPair>& own = part == 0 ? near : parts_[p].near;
            own.clear();
            const std::size_t from = list_.size() * p / count, to = list_.size() * (p + 1) / count;
            for (std::size_t k = from; k < to; ++k) look(list_[k], own);
        });
        for (std::size_t p = 1; p < parts_made; ++p) {
            near.insert(near.end(), parts_[p].near.begin(), parts_[p].near.end());
        }
    }

private:
    /// What a thread has found. In a cache line of its own, as the end changes with every pair.
    struct alignas(64) Part {
        std::vector<NearPair> near;
    };

    /// Pairs to be looked at: with fewer, a thread waits longer than it works.
    static constexpr std::size_t worth_a_thread = 1024;

    LazyWorkers workers_;
    std::vector<Part> parts_ = std::vector<Part>(1);  ///< one a thread
    std::size_t size_ = 0;
    std::vector<Listed> list_;
};

}  // namespace drape
