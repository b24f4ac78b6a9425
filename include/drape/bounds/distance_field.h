#pragma once

#include "drape/base/real.h"

namespace drape {

/// A body that a hierarchy is asked about, by how far points are from its surface.
class DistanceField {
public:
    virtual ~DistanceField() = default;

    /// From a point to the surface, less than zero inside [m]. Of two points it differs by no more than they are apart.
    [[nodiscard]] virtual Real distance(const Vec3& p) const = 0;
};

}  // namespace drape
