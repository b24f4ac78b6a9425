#include "drape/bounds/aabb.h"

namespace drape {

Aabb Aabb::fit(const Patch& patch) {
    Aabb box{patch.at(0, 0), patch.at(0, 0)};
    for_each_particle(patch, [&](const Vec3& p) {
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
    });
    return box;
}

}  // namespace drape
