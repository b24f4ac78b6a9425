#pragma once

#include "drape/contact/contact_row.h"
#include "drape/contact/near_pairs.h"

namespace drape {

/// The features of a contact of two cloths.
inline NearPair pair_of(const ContactRow& row) {
    NearPair pair;
    pair.features = {{row.particles[0].cloth, row.particles[3].cloth}, row.first_count, {}};
    for (std::size_t k = 0; k < 4; ++k) pair.features.particles[k] = row.particles[k].particle;
    pair.triangle = row.triangle;
    return pair;
}

/// Where they are nearest.
inline void set_plane(const NearPair& pair, ContactRow& row) {
    for (std::size_t k = 0; k < 4; ++k) row.particles[k].weight = pair.signed_weight(k);
    row.normal = pair.normal;
}

}  // namespace drape
