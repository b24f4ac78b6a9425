#pragma once

#include <span>
#include <vector>

#include "drape/sim/cloth.h"

namespace drape {

/// Marks what searches of cloth against cloth do with the nodes of the hierarchies that are shown. For pictures alone:
/// these searches are for what is nearer than the thickness at this moment, and no contact depends on them. (Those of a
/// run look farther ahead, find touching cells in another way, and keep what they find, see `SelfSearch`.)
/// @param cloths with hierarchies that are fit to be drawn, see `ContactSearch::show`
/// @param rows with the pairs in contact
/// @param touched receives the cells of each cloth with a particle of such a pair, in no particular order
/// @return what the searches have cost
TraversalStats mark_pairs(std::span<Cloth> cloths, std::span<const ContactRow> rows, const ContactSettings& contact,
                          std::vector<std::vector<int>>& touched);

}  // namespace drape
