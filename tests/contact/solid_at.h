#pragma once

#include <memory>
#include <utility>

#include "drape/contact/solid.h"

namespace drape::test {

/// A solid that stands still.
inline Solid solid_at(std::shared_ptr<const SolidShape> shape, const Vec3& position = Vec3::Zero()) {
    Solid solid;
    solid.shape = std::move(shape);
    solid.position = position;
    return solid;
}

}  // namespace drape::test
