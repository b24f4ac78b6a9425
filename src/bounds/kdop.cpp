#include "drape/bounds/kdop.h"

#include "extent_kernels.h"

namespace drape {

template <int K>
KDop<K> KDop<K>::fit(const Patch& patch) {
    std::array<Real, K / 2> least, most;
    kernels::dop_extents<K>(patch, least.data(), most.data());
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

template <int K>
void KDop<K>::outline(NodeState state, Outlines& outlines) const {
    std::array<Slab, K / 2> slabs;
    for (std::size_t k = 0; k < slabs.size(); ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        slabs[k].axis = dop_axes[static_cast<std::size_t>(dop_numbers<K>[k])];
        slabs[k].low = k < 3 ? box.low[axis] : low[k - 3];
        slabs[k].high = k < 3 ? box.high[axis] : high[k - 3];
    }
    append_polytope(slabs, state, outlines);
}

template struct KDop<6>;
template struct KDop<14>;
template struct KDop<18>;
template struct KDop<26>;

}  // namespace drape
