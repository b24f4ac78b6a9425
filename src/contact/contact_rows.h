#pragma once

#include <array>
#include <vector>

#include "drape/contact/contact.h"

namespace drape {

/// What a sweep needs of a contact that cannot move its second body, and nothing else: most sweeps then find all of
/// them in the cache nearest to the processor.
struct ContactRow {
    Vec3 normal, friction;
    std::array<Vec3, 2> offsets;  ///< subtracted from the motion of its particles, one after the other
    Real push, target;            ///< along the normal, as in `ContactPush`
    Real mass, sliding_mass, inverse_mass, friction_coefficient;
    std::array<Real, 3> weights, shares;
    std::array<int, 3> particles;  ///< of them the first `count`
    int count;
};

/// The contacts of one cloth.
struct ClothRows {
    Real* motion;           ///< of its particles, n x 3, a column a coordinate
    Eigen::Index stride;    ///< n
    std::size_t first = 0;  ///< row
    std::size_t end = 0;    ///< row after its last
};

/// The contacts that take part in a solve, in its order.
struct ContactRows {
    std::vector<ContactRow> rows;  ///< as many as there have ever been at once
    std::vector<ClothRows> cloths;
    int offsets = 0;  ///< how many of each row are not all zero
};

}  // namespace drape
