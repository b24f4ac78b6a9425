#pragma once

#include "drape/contact/relative_ways.h"

namespace drape::kernels {

// As the functions of the same names with `Kernels::Vector`, over as many particles as the spans have.

WaySums sum_ways(const Points& before, const Points& now);
bool find_reaches(const RelativeWays& ways, Real least, Real factor, std::span<const Real> allowed,
                  std::span<Real> reaches, std::span<Real> strayed);
bool are_within(const RelativeWays& ways, Real margin, std::span<const Real> reaches);

}  // namespace drape::kernels
