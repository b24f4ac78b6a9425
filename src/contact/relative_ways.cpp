#include "drape/contact/relative_ways.h"

#include <cmath>

#include "contact_geometry.h"
#include "kernels/relative_ways.h"

namespace drape {
namespace {

/// A particle's own way.
Real length_of(const Points& from, const Points& to, Eigen::Index p, const Vec3& common) {
    const auto along = [&](int axis) { return to(p, axis) - from(p, axis) - common[axis]; };
    return std::sqrt((along(0) * along(0) + along(1) * along(1)) + along(2) * along(2));
}

}  // namespace

WaySums sum_ways(const Points& before, const Points& now, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::sum_ways(before, now);
    return {before.colwise().sum().transpose(), (now - before).colwise().sum().transpose()};
}

bool find_reaches(const RelativeWays& ways, Real least, Real factor, std::span<const Real> allowed,
                  std::span<Real> reaches, std::span<Real> strayed, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::find_reaches(ways, least, factor, allowed, reaches, strayed);
    bool all_within = true;
    for (std::size_t k = 0; k < reaches.size(); ++k) {
        const auto p = static_cast<Eigen::Index>(k);
        reaches[k] = least + factor * length_of(ways.before, ways.now, p, ways.common);
        strayed[k] = reaches[k] + length_of(ways.kept, ways.before, p, ways.since_kept);
        all_within = all_within && strayed[k] <= allowed[k];
    }
    return all_within;
}

bool are_within(const RelativeWays& ways, Real margin, std::span<const Real> reaches, Kernels kernels) {
    if (kernels == Kernels::Vector) return kernels::are_within(ways, margin, reaches);
    for (std::size_t k = 0; k < reaches.size(); ++k) {
        const Real way = length_of(ways.before, ways.now, static_cast<Eigen::Index>(k), ways.common);
        if (!(way + margin <= reaches[k])) return false;
    }
    return true;
}

}  // namespace drape
