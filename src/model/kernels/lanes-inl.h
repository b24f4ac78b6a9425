// For kernels that Highway compiles several times: their file includes it once for each kind of processor.

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
HWY_INLINE Lanes3<V> plus(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Lanes3<V> minus(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE Lanes3<V> times(const Lanes3<V>& a, V factor) {
    return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

/// From x to z.
template <class V>
HWY_INLINE V dot(const Lanes3<V>& a, const Lanes3<V>& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
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
