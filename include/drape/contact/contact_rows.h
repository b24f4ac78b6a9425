#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "drape/contact/contact.h"

namespace drape {

/// What a sweep needs of a contact that cannot move its second body, and nothing else: most sweeps then find all of
/// them in the cache nearest to the processor.
struct CompactContact {
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

/// The contacts that take part in a solve, those of each cloth so ordered that neighbours share no particle where that
/// can be: a processor then solves several at a time. Results have the bits of any order in which contacts that share a
/// particle keep theirs.
struct ContactRows {
    std::vector<CompactContact> rows;  ///< as many as there have ever been at once
    std::vector<ClothRows> cloths;
    std::vector<std::size_t> places;  ///< rows of the contacts, in the order of these
    int offsets = 0;                  ///< how many of each row are not all zero

    /// Room for as many contacts of as many cloths without allocating, but for no more than a hundred thousand
    /// contacts: a scene with more of them at a time makes more room once.
    void reserve(std::size_t contacts, std::size_t cloth_count);

    /// What that room takes [bytes].
    [[nodiscard]] static std::size_t bytes_for(std::size_t contacts);

    void clear();

    /// Appends the places of the contacts of a cloth that take part. A contact is one level above the highest of those
    /// before it that share a particle with it; rows come level by level.
    /// @param particles of the cloth
    void add_places(const std::vector<Contact>& contacts, Eigen::Index particles);

private:
    std::vector<std::size_t> levels_;  ///< by particle, the first that has none of its contacts; 0 between calls
    std::vector<std::size_t> first_;   ///< by level, its next row
};

}  // namespace drape
