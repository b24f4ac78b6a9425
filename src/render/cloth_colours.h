#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "cloth_mesh.h"
#include "node_states.h"

namespace drape {

/// The colours from the least value to the most, in equal steps, in sRGB: dark to bright, violet to yellow, told
/// apart by colour-blind eyes and in print without colour. @cite viridis2015
std::span<const std::array<float, 3>, 9> value_colours();

/// Colours for what has no order, in sRGB: neighbouring nodes, or front and back. @cite okabe2008
std::span<const std::array<float, 3>, 4> group_colours();

/// What a colour by value means: 0 to `most`.
struct ColourScale {
    ColourBy by = ColourBy::Plain;
    double most = 1;        ///< 1, 2 or 5 times a power of ten, in `unit`
    std::string_view what;  ///< "strain"
    std::string_view unit;  ///< "%"; empty where colours are groups
    double units = 1;       ///< in one SI unit
};

/// The values that colour the cloths.
class ClothColours {
public:
    /// Finds them for all particles, and the scale that holds them.
    /// @par Cost O(n), nothing for a plain cloth
    void collect(const FrameView& view);

    [[nodiscard]] const ColourScale& scale() const { return scale_; }

    /// Into vertices that follow one another as the cloths do: of the scale in [0, 1]; or the number of a group, which
    /// the triangles of a cell take from its corner b.
    void fill(std::span<ClothVertex> vertices) const;

private:
    void collect_values(const FrameView& view);
    void collect_groups(const FrameView& view);

    ColourScale scale_;
    std::vector<float> values_;
    std::vector<NodeView> nodes_;
    std::vector<char> columns_, rows_;  ///< 1 where a node of the level starts
};

}  // namespace drape
