#include "drape/contact/contact_row.h"

#include <algorithm>

namespace drape {
namespace {

/// What touches: on a cloth and a body, on two cloths, or on two bodies.
std::array<int, 8> key_of(const ContactRow& row) {
    const auto& p = row.particles;
    const int group = static_cast<int>(std::max(row.kind, RowKind::Node));
    if (row.kind == RowKind::Bodies) return {group, row.first_body, row.body};
    if (row.kind == RowKind::Pair) {
        return {group,         p[0].cloth,    p[3].cloth,    row.first_count,
                p[0].particle, p[1].particle, p[2].particle, p[3].particle};
    }
    const bool is_particle = row.kind == RowKind::Particle;
    return {group,
            p[0].cloth,
            row.body,
            row.kind == RowKind::Node,
            row.triangle,
            !is_particle,
            is_particle ? p[0].particle : 0};
}

}  // namespace

std::strong_ordering compare(const ContactRow& first, const ContactRow& second) {
    return key_of(first) <=> key_of(second);
}

}  // namespace drape
