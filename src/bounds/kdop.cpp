#include "drape/bounds/kdop.h"

namespace drape {

template <int K>
KDop<K> KDop<K>::fit(const Patch& patch) {
    std::array<Real, K / 2> least, most;
    least.fill(std::numeric_limits<Real>::infinity());
    most.fill(-std::numeric_limits<Real>::infinity());
    for_each_particle(patch, [&](const Vec3& p) {
        for (std::size_t k = 0; k < K / 2; ++k) {
            const Real projection = dop_projection(dop_numbers<K>[k], p);
            least[k] = std::min(least[k], projection);
            most[k] = std::max(most[k], projection);
        }
    });
    return from_extents(least, most);
}

template <int K>
KDop<K> KDop<K>::from_extents(const std::array<Real, K / 2>& least, const std::array<Real, K / 2>& most) {
    KDop dop;
    dop.box = {{least[0], least[1], least[2]}, {most[0], most[1], most[2]}};

    // Two sums, each to half an epsilon, and this one
    const Real largest = dop.box.low.cwiseAbs().cwiseMax(dop.box.high.cwiseAbs()).sum();
    const Real rounding = 2 * std::numeric_limits<Real>::epsilon() * largest;
    for (std::size_t k = 0; k < cuts; ++k) {
        dop.low[k] = least[k + 3] - rounding;
        dop.high[k] = most[k + 3] + rounding;
    }
    return dop;
}

template struct KDop<6>;
template struct KDop<14>;
template struct KDop<18>;
template struct KDop<26>;

}  // namespace drape
