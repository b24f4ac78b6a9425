#pragma once

#include <algorithm>
#include <array>

#include "drape/model/force_sweep.h"
#include "force_kernels.h"

namespace drape::kernels {

/// One row a coordinate.
using Rows = std::array<Real*, 3>;

/// How a part lies in the scratch rows: with the columns and rows from which springs reach into it.
struct Strip {
    Strip(const Part& part, const Grid& whole)
        : grid(whole),
          end_row(part.first_row + part.rows),
          first(std::max(part.first_column - 2, 0)),
          last(std::min(part.first_column + part.columns + 1, whole.nx)),
          end(std::min(part.first_column + part.columns + 2, whole.nx)) {}

    Grid grid;
    int end_row;
    int first, last;  ///< columns whose springs are found
    int end;          ///< after the last column that these reach

    /// Where a column stands in a scratch row.
    [[nodiscard]] int at(int column) const { return column - first + Scratch::margin; }

    /// Where a row of particles is kept: three of the part follow one another, two after it stay.
    [[nodiscard]] int slot(int row) const { return row < end_row ? row % 3 : 3 + row - end_row; }
};

}  // namespace drape::kernels
