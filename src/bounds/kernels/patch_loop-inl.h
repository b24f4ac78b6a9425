// For kernels that Highway compiles several times: their file includes it once for each kind of processor.

#include <hwy/highway.h>

#include "drape/bounds/bounding_volume.h"
#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls work(d) with the widest vectors of which a row fills one; a single column has vectors of one lane.
template <class Work>
HWY_INLINE void with_vectors_for(int columns, Work work) {
    if (columns >= 16)
        work(hn::CappedTag<Real, 16>());
    else if (columns >= 8)
        work(hn::CappedTag<Real, 8>());
    else if (columns >= 4)
        work(hn::CappedTag<Real, 4>());
    else if (columns >= 2)
        work(hn::CappedTag<Real, 2>());
    else
        work(hn::CappedTag<Real, 1>());
}

/// Calls visit(i, j) for the first particle of each vector of a patch. The last vector of a row starts early enough to
/// end with the row: some particles are visited twice, which does not change a smallest or largest value.
template <class D, class Visit>
HWY_INLINE void for_each_vector(D d, const Patch& patch, Visit visit) {
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int j = 0; j < patch.rows; ++j) {
        int i = 0;
        for (; i + lanes <= patch.columns; i += lanes) visit(i, j);
        if (i < patch.columns) visit(patch.columns - lanes, j);
    }
}

/// A value that stays in its register: GCC 12 would load it from memory again for each use, and such loads, which
/// straddle cache lines, are what these loops wait for.
template <class V>
HWY_INLINE V loaded_once(V value) {
#if HWY_ARCH_X86_64 && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR
    asm("" : "+x"(value.raw));
#endif
    return value;
}

/// A vector of particles.
template <class D>
HWY_INLINE Lanes3<hn::Vec<D>> particles_from(D d, const Patch& patch, int start) {
    return {hn::LoadU(d, patch.x + start), hn::LoadU(d, patch.y + start), hn::LoadU(d, patch.z + start)};
}

/// The same point or direction in every lane.
template <class D, class Coordinates>
HWY_INLINE Lanes3<hn::Vec<D>> in_each_lane(D d, const Coordinates& v) {
    return {hn::Set(d, static_cast<Real>(v[0])), hn::Set(d, static_cast<Real>(v[1])),
            hn::Set(d, static_cast<Real>(v[2]))};
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
