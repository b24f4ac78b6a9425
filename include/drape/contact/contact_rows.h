#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "drape/contact/response.h"

namespace drape {

/// A vector in space and a zero, as one register holds them.
using Real4 = std::array<Real, 4>;

/// What a sweep needs of a contact that cannot move its second body, and nothing else: most sweeps then find all of
/// them in the cache nearest to the processor.
struct CompactContact {
    Real4 normal, friction;
    Real push, target;  ///< along the normal, as in `ContactPush`
    Real mass, sliding_mass, inverse_mass, friction_coefficient;
    std::array<Real, 3> weights, shares;
    std::array<int, 3> particles;  ///< their places in `ContactRows::motion`; of them the first `count`
    int count;
    std::array<Real4, 2> offsets;  ///< subtracted from the motion of its particles, one after the other
};

/// The contacts of a response that can be pushed, so ordered that neighbours share no particle where that can be, and
/// push equally many: a processor then solves several at a time. Results have the bits of any order in which contacts
/// that share a particle keep theirs.
struct ContactRows {
    /// A contact, and the places of its particles.
    struct Ordered {
        Contact* contact;
        std::array<int, 3> particles;
    };

    /// A particle that contacts push.
    struct Particle {
        int cloth, particle;
    };

    std::vector<Ordered> contacts;
    std::vector<Particle> particles;
    std::vector<Real4> motion;         ///< of these, in a solve
    std::vector<CompactContact> rows;  ///< first those of the contacts that take part in it; never made fewer
    int offsets = 0;                   ///< how many of each row are not all zero

    /// Room for as many contacts without allocating, but for no more than a hundred thousand: a scene with more of them
    /// at a time makes more room once.
    void reserve(std::size_t count);

    /// What that room takes [bytes].
    [[nodiscard]] static std::size_t bytes_for(std::size_t count);

    /// Forgets the contacts.
    void clear();

    /// Takes the contacts of the cloths. A contact is one level above the highest of those before it that share a
    /// particle with it; they come level by level, in each those that push more particles first.
    void order(std::span<const ClothInContact> cloths);

private:
    void order_cloth(const ClothInContact& cloth);

    struct Found {
        Ordered contact;
        std::size_t group;  ///< its level, and in this how many particles it pushes
    };
    struct Seen {
        std::size_t level = 0;  ///< the first that has none of the particle's contacts
        int place = 0;          ///< once there are any
    };

    std::vector<Found> found_;
    std::vector<Seen> seen_;          ///< by particle; as above between calls
    std::vector<std::size_t> first_;  ///< of each group, the next place
};

}  // namespace drape
