#include "drape/contact/contact_row.h"

#include <algorithm>
#include <tuple>

namespace drape {
namespace {

/// Those of a cloth with bodies, those between cloths, and those between bodies.
int group_of(const ContactRow& row) { return std::max(static_cast<int>(row.kind), static_cast<int>(RowKind::Node)); }

auto features_of_pair(const ContactRow& row) {
    const auto& p = row.particles;
    return std::tuple(p[0].cloth, p[3].cloth, row.first_count, p[0].particle, p[1].particle, p[2].particle,
                      p[3].particle);
}

auto feature_on_body(const ContactRow& row) {
    const bool of_particle = row.kind == RowKind::Particle;
    return std::tuple(row.particles[0].cloth, row.body, row.kind == RowKind::Node, row.triangle, !of_particle,
                      of_particle ? row.particles[0].particle : 0);
}

}  // namespace

std::strong_ordering compare(const ContactRow& first, const ContactRow& second) {
    const int group = group_of(first);
    if (const auto order = group <=> group_of(second); order != 0) return order;
    if (first.kind == RowKind::Pair) return features_of_pair(first) <=> features_of_pair(second);
    if (first.kind == RowKind::Bodies) {
        return std::tuple(first.first_body, first.body) <=> std::tuple(second.first_body, second.body);
    }
    return feature_on_body(first) <=> feature_on_body(second);
}

}  // namespace drape
