#pragma once

#include <algorithm>

#include "drape/model/grid.h"

namespace drape {

/// Divides the particles of a grid into tiles of 8 x 8; those in its last column and row may have fewer. Tile
/// t = row * columns + column.
struct Tiles {
    static constexpr int side = 8;

    explicit Tiles(const Grid& of) : grid(of), columns((of.nx + side - 1) / side), rows((of.ny + side - 1) / side) {}

    [[nodiscard]] int count() const { return columns * rows; }

    /// The particles of a tile.
    [[nodiscard]] GridRange particles(int tile) const {
        const int i = side * (tile % columns), j = side * (tile / columns);
        return {i, std::min(i + side, grid.nx), j, std::min(j + side, grid.ny)};
    }

    Grid grid;
    int columns, rows;
};

/// Whether all particles of a rectangle are of tiles that touch each other, be it at a corner.
/// @param range not empty
[[nodiscard]] inline bool in_touching_tiles(const GridRange& range) {
    const auto spans = [](int first, int end) { return (end - 1) / Tiles::side - first / Tiles::side; };
    return spans(range.first_column, range.end_column) <= 1 && spans(range.first_row, range.end_row) <= 1;
}

}  // namespace drape
