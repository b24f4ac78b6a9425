// Included once for each kind of processor, by kernels that Highway compiles several times: no include guard of the
// usual form.
#if defined(DRAPE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DRAPE_LANES_INL_H
#undef DRAPE_LANES_INL_H
#else
#define DRAPE_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// As many vectors in space as a register has lanes.
template <class V>
struct Lanes3 {
    V x, y, z;
};

template <class V>
HWY_INLINE Lanes3<V> difference(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// The lanes for which a mask is true, a bit each.
template <class D, class M>
HWY_INLINE std::uint32_t lane_bits(D d, M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
