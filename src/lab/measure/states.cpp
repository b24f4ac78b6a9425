#include "states.h"

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
        for (int axis = 0; axis < 3; ++axis) error(p, axis) = uniform<Real>(random);
    }
    state.x += error * (small_error * std::sqrt(static_cast<Real>(free)) / error.norm());
    return state;
}

double position_error(const Points& x, const Points& exact, Real side) {
    const double squares = static_cast<double>((x - exact).squaredNorm());
    return std::sqrt(squares / static_cast<double>(x.rows())) / static_cast<double>(side);
}

}  // namespace drape
