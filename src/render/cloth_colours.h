#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "drawn_nodes.h"

namespace drape {

/// The colours from the least value to the most, in equal steps, in sRGB: dark to bright, violet to yellow, told
/// apart by colour-blind eyes and in print without colour. The map "viridis" at multiples of 1/8. @cite viridis2015
inline constexpr std::array<std::array<float, 3>, 9> value_colours{{{0.267f, 0.004f, 0.329f},
                                                                    {0.278f, 0.176f, 0.482f},
                                                                    {0.231f, 0.322f, 0.545f},
                                                                    {0.173f, 0.447f, 0.557f},
                                                                    {0.129f, 0.569f, 0.549f},
                                                                    {0.157f, 0.682f, 0.502f},
                                                                    {0.369f, 0.788f, 0.384f},
                                                                    {0.678f, 0.863f, 0.188f},
                                                                    {0.992f, 0.906f, 0.145f}}};

/// Colours for what has no order, in sRGB: neighbouring nodes, or front and back. @cite okabe2008
inline constexpr std::array<std::array<float, 3>, 4> group_colours{
    {{0.902f, 0.624f, 0.000f}, {0.000f, 0.447f, 0.698f}, {0.337f, 0.706f, 0.914f}, {0.941f, 0.894f, 0.259f}}};

/// The least of 1, 2 and 5 times a power of ten that is not less, so that a scale seldom changes.
/// @pre value > 0
double round_number_above(double value);

/// What a colour by value means: 0 to `most`.
struct ColourScale {
    ColourBy by = ColourBy::Plain;
    double most = 1;        ///< 1, 2 or 5 times a power of ten, in `unit`
    std::string_view what;  ///< "strain"
    std::string_view unit;  ///< "%"; empty where colours are groups
    double units = 1;       ///< in one SI unit
};

/// What colours the cloths.
struct ClothColours {
    ColourScale scale;

    /// Of all particles, as the cloths follow one another: of the scale in [0, 1]; or the number of a group, which the
    /// triangles of a cell take from its corner b. None where cloths are plain, or coloured by their sides.
    std::vector<float> values;
};

/// @par Cost O(n), nothing for a plain cloth
ClothColours cloth_colours(const FrameView& view);

}  // namespace drape
