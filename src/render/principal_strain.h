#pragma once

#include <array>
#include <vector>

#include "drape/sim/frame_view.h"
#include "drawn_nodes.h"

namespace drape {

/// The strain of a cell in its plane, in the two directions in which it is the least and the greatest.
struct PrincipalStrain {
    Vec3 centre;                     ///< [m]
    std::array<Vec3, 2> directions;  ///< of length 1, along the cloth as it is drawn
    std::array<Real, 2> strains;     ///< of these, of the length at rest; below 0: compressed
};

/// @param column, row of the cell
PrincipalStrain principal_strain(const ClothView& cloth, Real blend, int column, int row);

/// A cross a cell, or one a block of cells of a fine grid: lines as long as the strains are large.
struct StrainCrosses {
    std::vector<Outlines::Edge> lines;

    /// What the longest lines stand for [%]: 1, 2 or 5 times a power of ten, no less than nine tenths of the strains.
    double full = 0;
};

/// Those of a view; none where its cloths are coloured by something else.
/// @par Cost at most 256 cells a cloth
StrainCrosses strain_crosses(const FrameView& view);

}  // namespace drape
