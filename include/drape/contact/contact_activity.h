#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drape/contact/response.h"

namespace drape {

/// For sweeps that skip contacts with hardly anything to solve: which balls and particles each contact pushes, when it
/// was last solved, and when each ball and particle was last pushed by more than can be neglected.
class ContactActivity {
public:
    /// A contact that is solved with others.
    struct Entry {
        std::array<int, 4> pushed{};  ///< numbers of balls and particles; 0: none
        std::int64_t last_solved = 0;
    };

    /// Forgets the contacts.
    void clear() {
        entries_.clear();
        balls_ = {};
    }

    /// Begins without contacts.
    /// @par Cost O(cloths); O(particles) the first time. Like the rest, allocates nothing once there have been as many
    ///           contacts before
    void begin(std::span<const ClothInContact> cloths, std::span<const Ball> balls);

    /// The next contact, in the order in which they are solved.
    void add(const Contact& contact);
    void add(const PairContact& contact);
    void add(const BallContact& contact);

    /// Of the contacts, in that order.
    [[nodiscard]] std::span<Entry> entries() { return entries_; }

    /// Whether any of what a contact pushes has been pushed since the contact was solved.
    [[nodiscard]] bool is_pending(const Entry& entry) const {
        const auto& [a, b, c, d] = entry.pushed;
        return std::max(std::max(last_push(a), last_push(b)), std::max(last_push(c), last_push(d))) > entry.last_solved;
    }

    /// Notes that a contact has been solved. Its own push leaves nothing to solve in it, so it is not pending
    /// afterwards.
    /// @param pushes whether by more than can be neglected
    void mark_solved(Entry& entry, bool pushes) {
        if (pushes) {
            ++now_;
            for (const int number : entry.pushed) last_push_[static_cast<std::size_t>(number)] = now_;
            last_push_[0] = 0;
        }
        entry.last_solved = now_;
    }

private:
    [[nodiscard]] std::int64_t last_push(int number) const { return last_push_[static_cast<std::size_t>(number)]; }
    void add_particles(const ContactPlane& contact, Entry& entry) const;
    [[nodiscard]] int number_of_ball(int ball) const;

    std::vector<Entry> entries_;
    std::vector<std::int64_t> last_push_;  ///< 0, then of each ball, then of each cloth's particles
    std::vector<int> first_;               ///< number of each cloth's first particle
    std::span<const Ball> balls_;
    std::int64_t now_ = 0;  ///< how many pushes could not be neglected, in all solves
};

}  // namespace drape
