#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drape/bounds/bounding_volume.h"
#include "drape/model/ball.h"
#include "drape/model/grid.h"

namespace drape {

/// The volumes of the hierarchy, and `Brute`: no hierarchy, every cell is a candidate.
enum class VolumeKind { Sphere, Brute };

/// How a hierarchy follows the cloth: `Rebuild` fits every node, from the root down, to all of its own particles.
enum class UpdateKind { Rebuild };

struct BroadPhaseParameters {
    VolumeKind volume = VolumeKind::Sphere;
    UpdateKind update = UpdateKind::Rebuild;
    int leaf_cells = 4;  ///< a leaf has at most leaf_cells x leaf_cells cells
    bool operator==(const BroadPhaseParameters&) const = default;
};

/// What one query did.
struct TraversalStats {
    std::int64_t nodes = 0;         ///< of the whole hierarchy
    std::int64_t visited = 0;       ///< reached by the traversal
    std::int64_t volume_tests = 0;  ///< volume against ball
    std::int64_t leaves = 0;        ///< reached and overlapping
    std::int64_t candidates = 0;    ///< cells handed on

    TraversalStats& operator+=(const TraversalStats& other);
};

/// What the last query did with a node.
enum class NodeState : std::uint8_t { Unvisited, Pruned, Visited, Leaf, Touching };

/// A node as the renderer draws it.
struct NodeView {
    Placement placement;
    NodeState state = NodeState::Unvisited;
};

/// Finds the cells of a cloth that may touch a ball.
class BroadPhase {
public:
    virtual ~BroadPhase() = default;

    /// Takes the cloth's present positions. They must outlive the queries that follow.
    /// @param x n x 3 [m]
    /// @param thickness by which the cloth is grown on all sides [m]
    virtual void build(const Points& x, Real thickness) = 0;

    /// @param cells receives the candidate cells, in no particular order: every cell with a triangle nearer to the ball
    ///        than `thickness`, and perhaps more. Cleared first; its capacity grows to the number of cells once.
    /// @pre `build` was called
    virtual TraversalStats query(const Ball& ball, std::vector<int>& cells) = 0;

    /// Levels of the hierarchy; 0 is the root alone.
    [[nodiscard]] virtual int levels() const = 0;

    /// The nodes of one level for drawing, with what the last query did to each.
    /// @param touched_cells cells with a contact; their leaves are `Touching`
    virtual void nodes_at(int level, std::span<const int> touched_cells, std::vector<NodeView>& nodes) const = 0;
};

std::unique_ptr<BroadPhase> make_broad_phase(const BroadPhaseParameters& parameters, const Grid& grid);

/// The names of all kinds, in the order of the enumerations.
std::span<const std::string> volume_names();
std::span<const std::string> update_names();

}  // namespace drape
