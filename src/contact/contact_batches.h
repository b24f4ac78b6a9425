#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "drape/contact/contact.h"

namespace drape {

/// Contacts that share no particle, side by side, as a sweep needs them: one array a number. Lanes that are left over
/// have no mass.
struct alignas(64) ContactBatch {
    static constexpr std::size_t size = 8;
    using Numbers = std::array<Real, size>;
    using Vectors = std::array<Numbers, 3>;
    using Slot = std::conditional_t<sizeof(Real) == sizeof(double), std::int64_t, std::int32_t>;

    /// One particle of each contact.
    struct alignas(64) Particles {
        std::array<Slot, size> slots{};  ///< of their x; y and z follow at distances of `size`
        Numbers weight{}, share{};
    };

    Vectors normal{}, start{};
    Vectors body{};  ///< motion of the second bodies, which nothing changes
    Numbers friction_coefficient{}, inverse_mass{}, mass{}, sliding_mass{};
    Numbers target{}, push{};
    Vectors friction{};
    std::array<Particles, 3> particles{};  ///< the first `particle_count`
    std::array<bool, 3> in_a_row{};        ///< each slot of these follows the one before
    std::size_t particle_count = 0, contact_count = 0;
};

/// Contacts of cloths with bodies that they cannot move, arranged for vectors: with the bits of a sweep in their own
/// order, for each comes in a later batch than those before it that share a particle with it, and what shares none may
/// change places. It keeps its memory from solve to solve.
class ContactBatches {
public:
    /// Where the numbers of a contact are.
    struct Lane {
        ContactBatch& batch;
        std::size_t number;
    };

    /// Room for as many contacts without allocating.
    void reserve(std::size_t contacts);

    /// Begins without contacts.
    void clear();

    /// Begins with the contacts of a cloth.
    /// @param motion of its particles, n x 3
    void begin_cloth(Points& motion);

    /// Adds a contact of this cloth, and its particles.
    /// @param given to it so far
    /// @return the lane, for its other numbers
    Lane add(const ContactPlane& contact, ContactPush& given);

    /// Sweeps until no contact changes by more than the tolerance.
    /// @param square receives that of the largest change in the last sweep
    /// @return how many sweeps
    int solve(Real tolerance, int most_sweeps, Real& square);

    /// Hands the results to cloths and contacts.
    void give_back();

private:
    struct Moved {
        int cloth, particle;
        std::size_t slot;
    };

    /// A particle of the present cloth.
    struct Known {
        std::size_t slot = 0;   ///< 0: none yet
        std::size_t later = 0;  ///< the first batch after all that have it
    };

    /// Motion of as many particles as a batch has lanes.
    struct alignas(64) Block {
        std::array<Real, 3 * ContactBatch::size> numbers{};
    };

    void forget_particles();
    [[nodiscard]] std::size_t batch_for(const ContactPlane& contact);
    [[nodiscard]] std::size_t slot_for(std::size_t batch, std::size_t k, std::size_t lane, int particle);

    std::vector<ContactBatch> batches_;
    std::vector<std::array<ContactPush*, ContactBatch::size>> given_;
    std::vector<std::array<std::size_t, 3>> fresh_;  ///< blocks for the particles that a batch is the first to have
    std::vector<Block> motion_;                      ///< of particles; the first is for lanes without a contact
    std::vector<Points*> cloths_;
    std::vector<Moved> moved_;
    std::vector<Known> known_;                 ///< by particle
    std::size_t of_last_cloth_ = 0;            ///< where the present cloth begins in `moved_`
    std::array<std::size_t, 3> first_open_{};  ///< batch of contacts of one, two and three particles
};

}  // namespace drape
