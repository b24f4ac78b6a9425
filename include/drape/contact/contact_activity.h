#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drape/contact/response.h"

namespace drape {

/// For solves that leave out what has nothing to solve: which bodies each contact pushes, when it was solved last, and
/// when each body was last pushed by more than can be neglected.
class ContactActivity {
public:
    /// A contact that is solved with others.
    struct Entry {
        std::array<int, 4> bodies{};  ///< their numbers; 0: none
        std::int64_t solved = 0;      ///< when it was solved last
    };

    /// Forgets the contacts.
    void clear() { entries_.clear(); }

    /// Begins without contacts.
    /// @par Cost O(cloths); O(particles) the first time
    void begin(std::span<const ClothInContact> cloths, std::span<const Ball> balls);

    /// The next contact, in the order in which they are solved.
    void add(const Contact& contact);
    void add(const PairContact& contact);
    void add(const BallContact& contact);

    /// Of the contacts, in that order.
    [[nodiscard]] std::span<Entry> entries() { return entries_; }

    /// Whether any of a contact's bodies has been pushed since that was solved.
    [[nodiscard]] bool is_pending(const Entry& entry) const {
        const auto& [a, b, c, d] = entry.bodies;
        return std::max(std::max(pushed(a), pushed(b)), std::max(pushed(c), pushed(d))) > entry.solved;
    }

    /// A contact has been solved; what that changes leaves nothing to solve in the contact itself.
    /// @param pushes whether by more than can be neglected
    void solved(Entry& entry, bool pushes) {
        if (pushes) {
            ++now_;
            for (const int body : entry.bodies) pushed_[static_cast<std::size_t>(body)] = now_;
            pushed_[0] = 0;
        }
        entry.solved = now_;
    }

private:
    [[nodiscard]] std::int64_t pushed(int body) const { return pushed_[static_cast<std::size_t>(body)]; }
    void add_particles(const ContactPlane& contact, Entry& entry) const;
    [[nodiscard]] int number_of_ball(int ball) const;

    std::vector<Entry> entries_;
    std::vector<std::int64_t> pushed_;  ///< of no body, of the balls, then of the particles of each cloth
    std::vector<int> first_;            ///< number of each cloth's first particle
    std::span<const Ball> balls_;
    std::int64_t now_ = 0;  ///< pushes that could not be neglected, of all solves
};

}  // namespace drape
