#include "divergence.h"

#include <cmath>
#include <limits>

#include "drape/base/numbers.h"
#include "drape/model/stencils.h"

namespace drape {
namespace {

/// How much faster than plausible particles may move. The whip crack of a free corner comes to about five times it.
constexpr Real margin = 20;

/// The fastest that gravity, wind, balls and pins can plausibly make a particle move against the rest [m/s].
Real plausible_speed(const Cloth& cloth, std::span<const Ball> balls, const Settings& settings) {
    const ClothModel& model = cloth.model;
    const Real height = model.hx * static_cast<Real>(model.grid.nx) + model.hy * static_cast<Real>(model.grid.ny);
    Real speed = std::sqrt(2 * gravity_scale(model) * height) + settings.wind.velocity.norm() + cloth.pin_speed;
    for (const Ball& ball : balls) speed += ball.velocity.norm();
    return speed;
}

/// Adds the spring of the particle that is the farthest from its rest length, or the first without a length.
void add_spring(const ClothModel& model, const Points& x, Divergence& found) {
    static const char* const kinds[] = {"structural", "structural", "shear", "shear", "bend", "bend"};
    const Grid& grid = model.grid;
    const int particle = found.particle, i = particle % grid.nx, j = particle / grid.nx;
    const auto stencils = spring_stencils(model);
    Real worst = -1;
    std::string name;
    for (std::size_t s = 0; s < stencils.size(); ++s) {
        if (stencils[s].law == SpringLaw{}) continue;
        for (const int side : {-1, 1}) {
            const int other_i = i + side * stencils[s].di, other_j = j + side * stencils[s].dj;
            if (other_i < 0 || other_i >= grid.nx || other_j < 0 || other_j >= grid.ny) continue;
            const int other = grid.particle(other_i, other_j);
            const Real ratio = (x.row(particle) - x.row(other)).norm() / stencils[s].rest_length;
            const Real off = std::isfinite(ratio) ? std::abs(ratio - 1) : std::numeric_limits<Real>::infinity();
            if (!(off > worst)) continue;
            worst = off;
            found.other = other;
            name =
                std::string(kinds[s]) + " spring to " + std::to_string(other) +
                (std::isfinite(ratio) ? " at " + real_text(static_cast<double>(ratio), 3) + " x its rest length" : "");
        }
    }
    if (!name.empty()) found.clause += ", its " + name;
}

Divergence diverged_at(const Cloth& cloth, Eigen::Index particle, const std::string& how) {
    const int p = static_cast<int>(particle), columns = cloth.model.grid.nx;
    Divergence found{"particle " + std::to_string(p) + " (column " + std::to_string(p % columns) + ", row " +
                         std::to_string(p / columns) + ") " + how,
                     p};
    add_spring(cloth.model, cloth.state.x, found);
    return found;
}

}  // namespace

Divergence divergence(const Cloth& cloth, const MotionSums& sums, std::span<const Ball> balls,
                      const Settings& settings) {
    const Points &x = cloth.state.x, &v = cloth.state.v;
    const auto n = static_cast<Real>(v.rows());

    // RMS speed against the mean motion: a long free fall is fast, but together
    const Vec3 mean = sums.velocities / n;
    const Real square = sums.squared_speeds / n - mean.squaredNorm();
    const Real limit = margin * plausible_speed(cloth, balls, settings);
    if (square <= limit * limit && sums.positions.allFinite()) return {};

    // Name the first particle that is not finite, else the fastest
    Eigen::Index fastest = 0;
    Real largest = -1;
    for (Eigen::Index p = 0; p < v.rows(); ++p) {
        if (!x.row(p).allFinite() || !v.row(p).allFinite()) return diverged_at(cloth, p, "is no longer finite");
        const Real speed = (v.row(p).transpose() - mean).squaredNorm();
        if (speed > largest) largest = speed, fastest = p;
    }
    return diverged_at(cloth, fastest, "at " + real_text(static_cast<double>(std::sqrt(largest)), 3) + " m/s");
}

}  // namespace drape
