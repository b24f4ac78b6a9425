#include "drape/contact/contact_rows.h"

#include <algorithm>
#include <utility>

namespace drape {

namespace {

constexpr std::size_t most_reserved = 100'000;  // contacts

}  // namespace

std::size_t ContactRows::bytes_for(std::size_t contacts) {
    return std::min(contacts, most_reserved) * (sizeof(CompactContact) + 3 * sizeof(std::size_t));
}

void ContactRows::reserve(std::size_t contacts, std::size_t cloth_count) {
    contacts = std::min(contacts, most_reserved);
    cloths.reserve(cloth_count);
    rows.reserve(contacts);
    places.reserve(contacts);
    levels_.reserve(contacts);
    first_.reserve(contacts);
}

void ContactRows::clear() {
    cloths.clear();
    places.clear();
    offsets = 0;
}

void ContactRows::add_places(const std::vector<Contact>& contacts, Eigen::Index particles) {
    const std::size_t begin = places.size();
    levels_.resize(std::max(levels_.size(), static_cast<std::size_t>(particles)));
    first_.clear();
    const auto level_at = [&](const PushedParticle& p) -> std::size_t& {
        return levels_[static_cast<std::size_t>(p.particle)];
    };
    for (const Contact& contact : contacts) {
        if (!contact.takes_part) continue;
        std::size_t level = 0;
        for (const PushedParticle& p : contact.pushed()) level = std::max(level, level_at(p));
        for (const PushedParticle& p : contact.pushed()) level_at(p) = level + 1;
        if (level == first_.size()) first_.push_back(0);
        ++first_[level];
        places.push_back(level);
    }
    std::size_t next = begin;
    for (std::size_t& first : first_) next += std::exchange(first, next);
    for (std::size_t k = begin; k < places.size(); ++k) places[k] = first_[places[k]]++;
    for (const Contact& contact : contacts) {
        for (const PushedParticle& p : contact.pushed()) level_at(p) = 0;
    }
}

}  // namespace drape
