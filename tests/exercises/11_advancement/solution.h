#pragma once

#include <functional>
#include <optional>

#include "drape/base/real.h"

namespace exercise_11 {

inline std::optional<drape::Real> first_contact(const std::function<drape::Real(drape::Real)>& distance,
                                                drape::Real speed, drape::Real near) {
    for (drape::Real t = 0; t <= 1;) {
        const drape::Real gap = distance(t);
        if (gap <= near) return t;
        t += (gap - near / 2) / speed;
    }
    return std::nullopt;
}

}  // namespace exercise_11
