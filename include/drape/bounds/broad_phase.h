#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/base/kernels.h"
#include "drape/bounds/sphere_fits.h"
#include "drape/model/ball.h"
#include "drape/model/grid.h"

namespace drape {

/// The volumes of the hierarchy, and `Brute`: no hierarchy, every cell is a candidate.
enum class VolumeKind { Sphere, Aabb, Kdop6, Kdop14, Kdop18, Kdop26, Obb, Brute };

/// How a hierarchy follows the cloth.
enum class UpdateKind {
    Rebuild,    ///< every node, from the root down, is fitted to all of its own particles: the dissertation's way
    Merge,      ///< leaves are fitted to their particles, every other node is merged from its children
    Insertion,  ///< cells are inserted one by one from the root down, and volumes grow on their way
    Refit,      ///< as merge, but only where particles have moved
    None        ///< the first tree is held, and inflated by the largest displacement since
};

/// Where a search may end before the leaves: the nodes whose children it has not visited then stand for what they hold,
/// as spheres. @cite hubbard1996
struct SearchLimit {
    static constexpr int all_levels = 30;
    int level = all_levels;  ///< the children of nodes of this level are not visited
    int tests = 0;           ///< volume tests of one query after which no children are visited; 0: no end

    [[nodiscard]] bool none() const { return level >= all_levels && tests == 0; }
    bool operator==(const SearchLimit&) const = default;
};

struct BroadPhaseParameters {
    VolumeKind volume = VolumeKind::Sphere;
    UpdateKind update = UpdateKind::Rebuild;
    int leaf_cells = 0;  ///< a leaf has at most leaf_cells x leaf_cells cells; 0: as `make_quadtree_nodes` measured
    SphereFit sphere_fit = SphereFit::Centroid;  ///< of a hierarchy of spheres
    SearchLimit search = {};
    Kernels kernels = Kernels::Vector;  ///< of fits
    bool operator==(const BroadPhaseParameters&) const = default;
};

/// Of two sets of cells; of a set with itself, each pair once.
[[nodiscard]] inline std::int64_t pairs_of_cells(std::int64_t cells, std::int64_t others, bool itself) {
    return itself ? cells * (cells + 1) / 2 : cells * others;
}

/// What one query did.
struct TraversalStats {
    std::int64_t nodes = 0;         ///< of the whole hierarchy
    std::int64_t visited = 0;       ///< by the traversal
    std::int64_t volume_tests = 0;  ///< volume against ball or plane
    std::int64_t pruned = 0;        ///< visited and found apart, with all that is below them
    std::int64_t leaves = 0;        ///< visited and overlapping
    std::int64_t candidates = 0;    ///< cells handed on, or pairs of them
    std::int64_t stopped = 0;       ///< nodes handed on as spheres, because a limited search ended there

    TraversalStats& operator+=(const TraversalStats& other);
};

/// A node at which a search ended.
struct StoppedNode : CellRange {
    BoundingSphere sphere;
    int cell = 0;  ///< in the middle of it
};

/// What a query hands on.
struct Candidates {
    /// Every cell that may touch, each once: ranges of a row each, in no particular order, or the one of all cells.
    std::vector<CellRange> cells;
    std::vector<StoppedNode> stopped;  ///< none unless the search is limited
};

/// Two leaves whose triangles may come near each other; both may be the same.
struct LeafPair {
    CellRange first, second;
};

/// How far a point is from the surface of a body, less than zero inside [m]. Of two points it differs by no more than
/// they are apart.
using DistanceFunction = std::function<Real(const Vec3&)>;

struct NodeView;
class FoldTest;

/// Finds the cells of a cloth that may touch a ball.
class BroadPhase {
public:
    virtual ~BroadPhase() = default;

    [[nodiscard]] virtual std::unique_ptr<BroadPhase> clone() const = 0;

    /// Follows the cloth to its present positions.
    /// @param x n x 3 [m]
    virtual void build(const Points& x) = 0;

    /// @param ball grown by the cloth's thickness
    /// @param found receives the candidates: every cell with a triangle that touches the ball, and perhaps more, unless
    ///        the search is limited. Cleared first; its capacity grows to what a search can find, once.
    /// @pre `build` was called
    virtual TraversalStats query(const Ball& ball, Candidates& found) = 0;

    /// Where the cloth may come as near to another one, or to itself, as a margin.
    /// @param other built by the same parameters; this one itself for a cloth against itself
    /// @param folds of the cloth against itself, built from the same positions: it prunes what cannot touch itself;
    ///        null: volumes alone
    /// @param pairs receives every pair of leaves with triangles, not both the same, that are no farther from each
    ///        other than the margin, and perhaps more; those of one cloth once, in either order. Cleared first
    /// @pre `build` was called for both
    virtual TraversalStats query(const BroadPhase& other, Real margin, const FoldTest* folds,
                                 std::vector<LeafPair>& pairs) = 0;

    /// Every cell with a triangle that comes as near to a body as a margin, and perhaps more; no limit of the search
    /// ends this one.
    /// @param distance from the body's surface
    /// @param margin [m] @pre `build` was called
    virtual TraversalStats query_near(const DistanceFunction& distance, Real margin, Candidates& found) = 0;

    /// By how much the nodes may be too small: the query makes up for it [m].
    [[nodiscard]] virtual Real slack() const = 0;

    /// How many levels the hierarchy has: 1 is the root alone, 0 none at all.
    [[nodiscard]] virtual int levels() const = 0;

    /// The nodes that cover the cloth at one level, that is of this level and leaves above it.
    /// @param nodes receives them; cleared first
    virtual void nodes_at(int level, std::vector<NodeView>& nodes) const = 0;
};

std::unique_ptr<BroadPhase> make_broad_phase(const BroadPhaseParameters& parameters, const Grid& grid);

/// The ball as a cloth of some thickness meets it.
[[nodiscard]] inline Ball grown(Ball ball, Real thickness) {
    ball.radius += thickness;
    return ball;
}

}  // namespace drape
