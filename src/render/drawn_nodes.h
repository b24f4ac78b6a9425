#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "drape/base/stopwatch.h"
#include "drape/bounds/node_view.h"
#include "drape/bounds/sphere_fits.h"
#include "drape/sim/frame_view.h"

namespace drape {

/// How a node is drawn: by what queries did with it, and whether anything in it touches. Cloth and balls that are
/// compared are drawn likewise, in a colour of their own, and so are the strains of cells.
enum class NodeState { Unvisited, Pruned, FalseInner, Untested, FalseLeaf, Touching, Compared, Stretched, Compressed };

/// What a legend says of lines, and the colour of both: red, green, blue, opacity.
struct LineLook {
    std::string_view text;
    std::array<float, 4> colour;
};

/// In the order of `NodeState`; the last two are seen on all of `value_colours`. Hues are apart for colour-blind eyes
/// too. @cite okabe2008
inline constexpr std::array<LineLook, 9> node_looks{{{"not visited", {0.62f, 0.65f, 0.70f, 0.45f}},
                                                     {"pruned", {0.10f, 0.11f, 0.14f, 0.65f}},
                                                     {"false positive, inner", {0.00f, 0.36f, 0.75f, 0.60f}},
                                                     {"not tested yet", {0.00f, 0.50f, 0.34f, 0.65f}},
                                                     {"false positive, leaf", {0.72f, 0.25f, 0.58f, 0.80f}},
                                                     {"touching", {1.00f, 0.76f, 0.05f, 0.85f}},
                                                     {"compared", {0.05f, 0.05f, 0.08f, 0.75f}},
                                                     {"stretched", {0.95f, 0.30f, 0.05f, 0.95f}},
                                                     {"compressed", {0.45f, 0.92f, 1.00f, 0.95f}}}};

/// The cells of a cloth with a contact, to be asked for by rectangles.
class TouchedCells {
public:
    /// @param tested whether candidates have been tested: before the first step they have not
    /// @param more cells that touch, in any order
    TouchedCells(const Grid& grid, std::span<const ContactRow> contacts, bool tested, std::span<const int> more = {});
    TouchedCells(const ClothView& cloth, const StepReport& report)
        : TouchedCells(cloth.model.grid, cloth.contacts, report.step > 0, cloth.pair_cells) {}

    /// @par Cost O(rows log(touched cells))
    [[nodiscard]] bool any_in(const CellRange& cells) const;

    /// Of a node that overlaps it is known whether anything in it touches, once that has been tested.
    [[nodiscard]] NodeState state_of(const NodeView& node) const;

private:
    int columns_;  ///< of cells
    bool tested_;
    std::vector<int> cells_;  ///< ascending, each once
};

/// Which level of the hierarchies is shown.
struct ShownLevel {
    int levels = 0;  ///< of the deepest hierarchy
    int level = 0;
    bool all = false;  ///< `view.level` is past the finest
};
ShownLevel shown_level(const FrameView& view);

/// Nodes of one level and no other.
/// @param nodes receives them; cleared first
void nodes_of_level(const BroadPhase& hierarchy, int level, std::vector<NodeView>& nodes);

/// The nodes of a hierarchy that are shown: those of the shown level or, level after level, all.
std::vector<NodeView> shown_nodes(const FrameView& view, const BroadPhase& hierarchy);

/// What queries did with the nodes of one level.
struct LevelCounts {
    int nodes = 0;
    int visited = 0;          ///< pruned or not
    int pruned = 0;           ///< visited and found apart
    int false_positives = 0;  ///< overlapping, and nothing in them touches, as far as that was tested
    int touching = 0;

    void add(std::span<const NodeView> added, const TouchedCells& touched);
};

/// Nodes as shaders take them, in the true shape of their volumes: spheres, and the edges of bodies with flat faces.
struct Outlines {
    struct Sphere {
        Eigen::Vector3f centre;
        float radius;
        NodeState state;
    };
    struct End {
        Eigen::Vector3f point;
        NodeState state;
    };
    struct Edge {
        Edge(const Vec3& a, const Vec3& b, NodeState of) : from{a.cast<float>(), of}, to{b.cast<float>(), of} {}
        End from, to;
    };
    std::vector<Sphere> spheres;
    std::vector<Edge> edges;
};

/// Appends the volume of a node. A sphere is drawn grown by the slack of its hierarchy [m]; of other volumes the faces
/// are as fitted. Edges of boxes without length are left out, and edges of k-DOPs much shorter than the whole.
/// @par Cost of a k-DOP O(slabs^3)
void append_outline(const AnyVolume& volume, Real slack, NodeState state, Outlines& outlines);

/// How much larger a node's volume is than it must be: the radius of its sphere (of the sphere about it, for another
/// volume), with the hierarchy's slack, over that of the smallest sphere about its particles.
/// @param x n x 3 [m]
inline double tightness(const NodeView& node, Real slack, const Grid& grid, const Points& x) {
    const auto radius_of = [](const auto& volume) { return volume.sphere().radius; };
    const Real least = fit_smallest_sphere(patch_of(grid, node.cells, x)).radius;
    const Real radius = std::visit(radius_of, node.volume) + slack;
    return least > 0 ? static_cast<double>(radius / least) : std::numeric_limits<double>::infinity();
}

/// How well and how fast the nodes of a level are fitted.
struct LevelFit {
    double tightness = 0;  ///< mean of the nodes, over all cloths
    double seconds = 0;    ///< that it takes to fit them all, each to its own particles
};

/// The fits of all levels; looked at again now and then while the cloth moves, and at once where it has stopped, or for
/// another hierarchy.
class LevelFits {
public:
    /// @return one for each level, valid until the next call
    /// @par Cost O(particles) a level, about thirteen passes, in one of `frames_between` frames
    std::span<const LevelFit> look(const FrameView& view, int levels) {
        const BroadPhaseParameters parameters = broad_phase_of(*view.settings);
        const bool same = parameters_ == parameters && fits_.size() == static_cast<std::size_t>(levels);
        ++frames_;
        const bool waits = frames_ < frames_between && !view.paused;
        if (same && (waits || view.report->step == step_)) return fits_;
        parameters_ = parameters;
        step_ = view.report->step;
        frames_ = 0;
        fits_.clear();
        for (int level = 0; level < levels; ++level) fits_.push_back(fit_of(view, level));
        return fits_;
    }

private:
    static constexpr int frames_between = 30;

    [[nodiscard]] LevelFit fit_of(const FrameView& view, int level) const {
        LevelFit fit;
        double count = 0;
        std::vector<NodeView> nodes;
        for (const ClothView& cloth : view.cloths) {
            nodes_of_level(*cloth.hierarchy, level, nodes);
            for (const NodeView& node : nodes) {
                fit.tightness += tightness(node, cloth.hierarchy->slack(), cloth.model.grid, cloth.x);
                ++count;
            }
            const Stopwatch watch;
            refit_nodes(*parameters_, cloth.model.grid, cloth.x, nodes);
            fit.seconds += watch.seconds();
        }
        if (count > 0) fit.tightness /= count;
        return fit;
    }

    std::vector<LevelFit> fits_;
    std::optional<BroadPhaseParameters> parameters_;  ///< of the last look
    std::int64_t step_ = -1;
    int frames_ = 0;
};

}  // namespace drape
