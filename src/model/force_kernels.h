#pragma once

#include <functional>

#include "drape/model/force_sweep.h"

/// The loop over springs, vectorised for several generations of processors, of which the best that there is gets chosen
/// at run time. Every particle's sum is made in one order with exact roots and quotients: the bits are the same on all.
namespace drape::kernels {

/// What the forces depend on; three pointers are one a coordinate.
struct ForceInput {
    const ClothModel* model;
    const Real* x[3];     ///< [m]
    const Real* v[3];     ///< [m/s]
    const Real* wind[3];  ///< [N], of every particle; null if there is none
};

/// A rectangle of particles.
struct Part {
    int first_column, columns, first_row, rows;
};

/// The most columns that a sweep looks at: its three rows then fit into the nearest cache. It looks at two columns
/// before a part and one after it, too.
constexpr int looked_at = 128, most_columns = looked_at - 3;

/// Calls use(run) for each row of a part.
void forces_on(const ForceInput& input, const Part& part, const std::function<void(const ForceRun&)>& use);

}  // namespace drape::kernels
