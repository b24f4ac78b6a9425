#pragma once

#include "drape/model/stencils.h"

namespace drape::kernels {

/// What is known of the springs of one direction, as `Jacobian` keeps it: seven columns, or four if clamped.
using SpringTerms = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// The terms at a state. A length that is as good as zero makes n and T/|d| zero.
void linearise(const SpringRows& rows, const Points& x, const Points& v, SpringTerms& terms);

/// y += their part of (k_scale K + d_scale D) u.
/// @param along what a block does to a vector along the spring, k_scale k + d_scale c
void add_product(const SpringRows& rows, const SpringTerms& terms, Real along, Real k_scale, const Points& u,
                 Points& y);

}  // namespace drape::kernels
