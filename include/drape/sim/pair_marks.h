#pragma once

#include <span>
#include <vector>

#include "drape/sim/cloth.h"

namespace drape {

/// Marks what searches of cloth against cloth do with the nodes of the hierarchies that are shown. For pictures alone:
/// these searches are for what is nearer than the thickness at this moment, and no contact depends on them. (Those of a
/// run look farther ahead, find touching cells in another way, and keep what they find, see `SelfSearch`.)
class PairMarks {
public:
    /// @param cloths with hierarchies that are fit to be drawn, see `ContactSearch::show`
    /// @param pairs in contact
    /// @return what the searches have cost
    TraversalStats mark(std::span<Cloth> cloths, std::span<const ContactRow> rows, const ContactSettings& contact);

    /// The cells of a cloth with a particle of such a pair, in no particular order.
    [[nodiscard]] std::span<const int> touched_cells(std::size_t cloth) const { return touched_[cloth]; }

private:
    std::vector<std::vector<int>> touched_;
    std::vector<LeafPair> leaves_;
};

}  // namespace drape
