#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "drape/bounds/node_view.h"
#include "drape/sim/frame_view.h"

namespace drape {

/// How a node is drawn: by what queries did with it, and whether anything in it touches. Cloth and balls that are
/// compared are drawn likewise, in a colour of their own, and so are the strains of cells.
enum class NodeState { Unvisited, Pruned, Visited, Leaf, FalseCandidate, Touching, Compared, Stretched, Compressed };

/// What a legend says of lines, and the colour of both: red, green, blue, opacity.
struct LineLook {
    std::string_view text;
    std::array<float, 4> colour;
};

/// In the order of `NodeState`; the last two are seen on all of `value_colours`. Hues are apart for colour-blind eyes
/// too. @cite okabe2008
inline constexpr std::array<LineLook, 9> node_looks{{{"not visited", {0.45f, 0.48f, 0.52f, 0.40f}},
                                                     {"pruned", {0.20f, 0.23f, 0.28f, 0.50f}},
                                                     {"visited", {0.00f, 0.36f, 0.75f, 0.60f}},
                                                     {"leaf, not tested yet", {0.00f, 0.50f, 0.34f, 0.65f}},
                                                     {"false candidate", {0.72f, 0.25f, 0.58f, 0.80f}},
                                                     {"touching", {1.00f, 0.76f, 0.05f, 0.85f}},
                                                     {"compared", {0.05f, 0.05f, 0.08f, 0.75f}},
                                                     {"stretched", {0.95f, 0.30f, 0.05f, 0.95f}},
                                                     {"compressed", {0.45f, 0.92f, 1.00f, 0.95f}}}};

/// The cells of a cloth with a contact, to be asked for by rectangles.
class TouchedCells {
public:
    /// @param tested whether candidates have been tested: before the first step they have not
    /// @param more cells that touch, in any order
    void take(const Grid& grid, std::span<const ContactRow> contacts, bool tested, std::span<const int> more = {});
    void take(const ClothView& cloth, const StepReport& report) {
        take(cloth.model.grid, cloth.contacts, report.step > 0, cloth.pair_cells);
    }

    /// @par Cost O(rows log(touched cells))
    [[nodiscard]] bool any_in(const CellRange& cells) const;

    /// Of a leaf that was handed on it is known whether it touches, once it has been tested.
    [[nodiscard]] NodeState state_of(const NodeView& node) const;

private:
    int columns_ = 1;  ///< of cells
    bool tested_ = false;
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

/// Lists the nodes of a hierarchy that are shown.
class ShownNodes {
public:
    /// @return those of the shown level or, level after level, all; valid until the next call
    std::span<const NodeView> list(const FrameView& view, const BroadPhase& hierarchy);

private:
    std::vector<NodeView> all_, of_level_;
};

/// What queries did with the nodes of one level.
struct LevelCounts {
    int nodes = 0;
    int visited = 0;          ///< pruned or not
    int pruned = 0;           ///< visited and found apart
    int false_positives = 0;  ///< overlapping, and nothing in them touches
    int touching = 0;

    void add(std::span<const NodeView> added, const TouchedCells& touched);
};

}  // namespace drape
