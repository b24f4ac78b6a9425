#pragma once

#include <span>
#include <type_traits>
#include <variant>

#include "drape/bounds/aabb.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// Any volume that a node may have, in the order of their kinds.
using AnyVolume = std::variant<BoundingSphere, Aabb, KDop<6>, KDop<14>, KDop<18>, KDop<26>, Obb>;
static_assert(std::variant_size_v<AnyVolume> == static_cast<std::size_t>(VolumeKind::Brute) &&
                  std::variant_size_v<AnyVolume> + 1 == enum_count<VolumeKind>,
              "every kind has its volume, and brute force, which has none, is the last kind");

/// What visit(std::type_identity<Volume>()) returns for the volume of a kind. @pre any kind but `Brute`
template <std::size_t number = 0, class Visit>
auto with_volume(VolumeKind kind, Visit visit) {
    constexpr auto volume_kind = static_cast<VolumeKind>(number);
    if constexpr (number + 1 < std::variant_size_v<AnyVolume>) {
        if (kind != volume_kind) return with_volume<number + 1>(kind, visit);
    }
    DRAPE_ASSERT(kind == volume_kind);
    return visit(std::type_identity<std::variant_alternative_t<number, AnyVolume>>());
}

/// A node as a hierarchy shows it.
struct NodeView {
    QuadtreeNode cells;
    NodeVisit visit;   ///< the most that a query since the last build did
    AnyVolume volume;  ///< as fitted: `BroadPhase::slack` is to be added
};

/// Fits the volume of each of these nodes to its own particles, as a hierarchy of these parameters does that is rebuilt
/// node by node. Does nothing for brute force.
/// @param x n x 3 [m]
/// @par Cost O(particles) for the nodes of one level
void refit_nodes(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x, std::span<NodeView> nodes);

}  // namespace drape
