#include "disturbed_start.h"

#include <cmath>
#include <random>

#include "drape/base/exact_math.h"

namespace drape {

ClothState disturbed(const ClothModel& model, ClothState state) {
    std::mt19937 random(1);
    Points error = Points::Zero(state.x.rows(), 3);
    int free = 0;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) continue;
        ++free;
        for (int axis = 0; axis < 3; ++axis) error(p, axis) = draw_even<Real>(random);
    }
    state.x += error * (small_error * std::sqrt(static_cast<Real>(free)) / error.norm());
    return state;
}

}  // namespace drape
