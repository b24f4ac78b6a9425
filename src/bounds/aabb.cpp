#include "drape/bounds/aabb.h"

#include "patch_kernels.h"

namespace drape {

Aabb Aabb::fit(const Patch& patch) {
    Aabb box;
    kernels::bounding_box(patch, box.low.data(), box.high.data());
    return box;
}

}  // namespace drape
