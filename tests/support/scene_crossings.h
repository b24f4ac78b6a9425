#pragma once

#include <memory>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "support/crossings.h"

namespace drape::test {

/// Counts the crossings of all cloths of a scene exactly, fast enough for every step: cells that are to be tested come
/// from hierarchies of its own, of boxes and without the cone test.
class SceneCrossings {
public:
    /// @param cloths the same in every call, each with its model and its state
    template <class Cloths>
    std::int64_t count(const Cloths& cloths) {
        trees_.resize(cloths.size());
        boxes_.resize(cloths.size());
        std::vector<BoxedCloth> boxed;
        for (std::size_t c = 0; c < cloths.size(); ++c) {
            const Grid& grid = cloths[c].model.grid;
            if (!trees_[c]) trees_[c] = make_broad_phase({.volume = VolumeKind::Aabb, .leaf_cells = 2}, grid);
            trees_[c]->build(cloths[c].state.x);
            boxes_[c].build(grid, cloths[c].state.x);
            boxed.push_back({{static_cast<int>(c), grid, cloths[c].state.x}, boxes_[c]});
        }
        std::int64_t count = 0;
        for (std::size_t a = 0; a < boxed.size(); ++a) {
            for (std::size_t b = a; b < boxed.size(); ++b) {
                trees_[a]->query(*trees_[b], 0, nullptr, leaves_);
                count += crossings(boxed[a], boxed[b], leaves_);
            }
        }
        return count;
    }

private:
    std::vector<std::unique_ptr<BroadPhase>> trees_;
    std::vector<CellBoxes> boxes_;
    std::vector<LeafPair> leaves_;
};

}  // namespace drape::test
