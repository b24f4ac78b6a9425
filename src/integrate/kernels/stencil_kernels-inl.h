#include "integrate/kernels/stencil_kernels.h"

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

using StencilLanes = hn::CappedTag<float, StencilRuns::lanes>;
using StencilVector = Lanes3<hn::Vec<StencilLanes>>;

HWY_INLINE StencilVector load_lanes(StencilLanes d, const float* from, std::ptrdiff_t axis) {
    return {hn::LoadU(d, from), hn::LoadU(d, from + axis), hn::LoadU(d, from + 2 * axis)};
}

HWY_INLINE void store_lanes(const StencilVector& values, StencilLanes d, float* to, std::ptrdiff_t axis) {
    hn::StoreU(values.x, d, to);
    hn::StoreU(values.y, d, to + axis);
    hn::StoreU(values.z, d, to + 2 * axis);
}

/// Blocks times vectors.
/// @param entry from an entry of a block to the next
HWY_INLINE StencilVector block_times(StencilLanes d, const float* block, std::ptrdiff_t entry, const StencilVector& u) {
    const auto xy = hn::LoadU(d, block + entry), xz = hn::LoadU(d, block + 2 * entry);
    const auto yz = hn::LoadU(d, block + 4 * entry);
    return {dot(StencilVector{hn::LoadU(d, block), xy, xz}, u),
            dot(StencilVector{xy, hn::LoadU(d, block + 3 * entry), yz}, u),
            dot(StencilVector{xz, yz, hn::LoadU(d, block + 5 * entry)}, u)};
}

void take_step_of(const StencilStep& step, int row) {
    const StencilLanes d;
    const StencilMatrix& a = *step.a;
    const std::ptrdiff_t axis = static_cast<std::ptrdiff_t>(a.rows) * a.runs.length, first = a.runs.at(row);
    const auto of_u = hn::Set(d, step.of_u), of_r = hn::Set(d, step.of_r);
    const StencilTerms terms(a, row);
    // With zeros up to a whole vector, which stay
    for (int i = 0; i < a.runs.nodes; i += static_cast<int>(hn::Lanes(d))) {
        const std::ptrdiff_t p = first + i;
        StencilVector product{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        if (step.u != nullptr) {
            for (const auto& [block, to] : terms) {
                product = plus(product, block_times(d, block + i, a.runs.length, load_lanes(d, step.u + p + to, axis)));
            }
        }
        const StencilVector r = minus(load_lanes(d, step.from + p, axis), product);
        if (step.r != nullptr) store_lanes(r, d, step.r + p, axis);
        if (step.out == nullptr) continue;
        StencilVector out = times(block_times(d, step.b + p, axis, r), of_r);
        if (step.of_u != 0) out = plus(times(load_lanes(d, step.u + p, axis), of_u), out);
        if (step.add != nullptr) out = plus(load_lanes(d, step.add + p, axis), out);
        store_lanes(out, d, step.out + p, axis);
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(take_step_of);

void take_step(const StencilStep& step, int row) { HWY_DYNAMIC_DISPATCH(take_step_of)(step, row); }

}  // namespace drape::kernels
#endif
