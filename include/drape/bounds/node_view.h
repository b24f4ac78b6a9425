#pragma once

#include <type_traits>
#include <variant>

#include "drape/bounds/aabb.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// Any volume that a node may have.
using AnyVolume = std::variant<BoundingSphere, Aabb, KDop<6>, KDop<14>, KDop<18>, KDop<26>, Obb>;

/// What visit(std::type_identity<Volume>()) returns for the volume of a kind. @pre any kind but `Brute`
template <class Visit>
auto with_volume(VolumeKind kind, Visit visit) {
    switch (kind) {
        case VolumeKind::Sphere:
            return visit(std::type_identity<BoundingSphere>());
        case VolumeKind::Aabb:
            return visit(std::type_identity<Aabb>());
        case VolumeKind::Kdop6:
            return visit(std::type_identity<KDop<6>>());
        case VolumeKind::Kdop14:
            return visit(std::type_identity<KDop<14>>());
        case VolumeKind::Kdop18:
            return visit(std::type_identity<KDop<18>>());
        case VolumeKind::Kdop26:
            return visit(std::type_identity<KDop<26>>());
        case VolumeKind::Obb:
        case VolumeKind::Brute:
            break;
    }
    DRAPE_ASSERT(kind == VolumeKind::Obb);
    return visit(std::type_identity<Obb>());
}

/// A node as a hierarchy shows it.
struct NodeView {
    QuadtreeNode cells;
    NodeVisit visit;   ///< the most that a query since the last build did
    AnyVolume volume;  ///< as fitted: `BroadPhase::slack` is to be added
};

}  // namespace drape
