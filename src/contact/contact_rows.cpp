#include "drape/contact/contact_rows.h"

#include <algorithm>
#include <utility>

namespace drape {

namespace {

constexpr std::size_t max_reserved = 100'000;  // contacts

/// By how many particles a contact pushes.
constexpr std::size_t groups_of_level = 3;

}  // namespace

std::size_t ContactRows::bytes_for(std::size_t count) {
    constexpr std::size_t of_contact = sizeof(Ordered) + sizeof(Particle) + sizeof(Real4) + sizeof(CompactContact) +
                                       sizeof(Found) + sizeof(Seen) + groups_of_level * sizeof(std::size_t);
    return std::min(count, max_reserved) * of_contact;
}

/// There are no more particles than that either: a cloth has two contacts a triangle at the most.
void ContactRows::reserve(std::size_t count) {
    count = std::min(count, max_reserved);
    contacts.reserve(count);
    particles.reserve(count);
    motion.reserve(count);
    rows.reserve(count);
    found_.reserve(count);
    seen_.reserve(count);
    first_.reserve(groups_of_level * (count + 1));
}

void ContactRows::clear() {
    contacts.clear();
    particles.clear();
}

void ContactRows::order(std::span<const ClothInContact> cloths) {
    clear();
    for (const ClothInContact& cloth : cloths) order_cloth(cloth);
}

void ContactRows::order_cloth(const ClothInContact& cloth) {
    const std::size_t begin = contacts.size(), first_particle = particles.size();
    seen_.resize(std::max(seen_.size(), static_cast<std::size_t>(cloth.state.x.rows())));
    found_.clear();
    first_.clear();
    for (Contact& contact : cloth.contacts) {
        if (contact.inverse_mass == 0) continue;
        Found found{{&contact, {}}, 0};
        const auto pushed = contact.pushed();
        std::size_t level = 0;
        for (std::size_t k = 0; k < pushed.size(); ++k) {
            Seen& seen = seen_[static_cast<std::size_t>(pushed[k].particle)];
            if (seen.level == 0) {
                seen.place = static_cast<int>(particles.size());
                particles.push_back({pushed[k].cloth, pushed[k].particle});
            }
            found.contact.particles[k] = seen.place;
            level = std::max(level, seen.level);
        }
        for (const ContactParticle& p : pushed) seen_[static_cast<std::size_t>(p.particle)].level = level + 1;
        found.group = groups_of_level * (level + 1) - pushed.size();
        if (found.group >= first_.size()) first_.resize(groups_of_level * (level + 1));
        ++first_[found.group];
        found_.push_back(found);
    }
    std::size_t next = begin;
    for (std::size_t& first : first_) next += std::exchange(first, next);
    contacts.resize(next);
    for (const Found& found : found_) contacts[first_[found.group]++] = found.contact;
    for (std::size_t k = first_particle; k < particles.size(); ++k) {
        seen_[static_cast<std::size_t>(particles[k].particle)] = {};
    }
}

}  // namespace drape
