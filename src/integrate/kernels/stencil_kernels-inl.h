#include "integrate/kernels/stencil_kernels.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// y += block u for some nodes beside each other.
template <int fixed>
HWY_INLINE void add_products(const float* HWY_RESTRICT c, const float* HWY_RESTRICT ux, const float* HWY_RESTRICT uy,
                             const float* HWY_RESTRICT uz, float* HWY_RESTRICT yx, float* HWY_RESTRICT yy,
                             float* HWY_RESTRICT yz, int some) {
    constexpr int group = StencilLayout::group;
    const int count = fixed > 0 ? fixed : some;
    for (int i = 0; i < count; ++i) {
        const float x = ux[i], y = uy[i], z = uz[i];
        const float xy = c[group + i], xz = c[2 * group + i], yz_ = c[4 * group + i];
        yx[i] += c[i] * x + xy * y + xz * z;
        yy[i] += xy * x + c[3 * group + i] * y + yz_ * z;
        yz[i] += xz * x + yz_ * y + c[5 * group + i] * z;
    }
}

/// Of one group of nodes.
template <int fixed>
HWY_INLINE void multiply_group(const float* c, int nodes, int base, const int* shifts, const float* u, float* y) {
    const float *const ux = u + base, *const uy = ux + nodes, *const uz = uy + nodes;
    float *const yx = y + base, *const yy = yx + nodes, *const yz = yy + nodes;
    for (int k = 0; k < StencilLayout::blocks; ++k, c += StencilLayout::entries * StencilLayout::group) {
        const int shift = shifts[k], left = nodes - base - shift;
        const int count = left < StencilLayout::group ? left : StencilLayout::group;
        if ((k > 0 && shift <= 0) || count <= 0) continue;
        add_products<fixed>(c, ux + shift, uy + shift, uz + shift, yx, yy, yz, count);
        if (k > 0) add_products<fixed>(c, ux, uy, uz, yx + shift, yy + shift, yz + shift, count);
    }
}

/// Of all groups; `fixed` is the number of nodes of those that have all their neighbours.
void multiply_stencils_of(const float* stencils, int nodes, const int* shifts, int farthest, const float* u, float* y) {
    constexpr int group = StencilLayout::group;
    for (int base = 0; base < nodes; base += group) {
        const float* const c =
            stencils + static_cast<std::ptrdiff_t>(base) * StencilLayout::blocks * StencilLayout::entries;
        if (base + group + farthest <= nodes) {
            multiply_group<group>(c, nodes, base, shifts, u, y);
        } else {
            multiply_group<0>(c, nodes, base, shifts, u, y);
        }
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(multiply_stencils_of);

void multiply_stencils(const float* stencils, int nodes, const std::array<int, StencilLayout::blocks>& shifts,
                       const float* u, float* y) {
    std::fill(y, y + 3 * static_cast<std::ptrdiff_t>(nodes), 0.0F);
    const int farthest = *std::ranges::max_element(shifts);
    HWY_DYNAMIC_DISPATCH(multiply_stencils_of)(stencils, nodes, shifts.data(), farthest, u, y);
}

}  // namespace drape::kernels
#endif
