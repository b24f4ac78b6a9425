#include "divergence.h"

#include <cmath>

#include "drape/base/numbers.h"

namespace drape {
namespace {

/// How much faster than any honest cause particles may move. Whip cracks at a free corner reach about five.
constexpr Real margin = 20;

/// The fastest that anything in the scene can honestly make a particle move against the rest [m/s].
Real honest_speed(const Cloth& cloth, std::span<const Ball> balls, const Settings& settings) {
    const ClothModel& model = cloth.model;
    const Real reach = model.hx * static_cast<Real>(model.grid.nx) + model.hy * static_cast<Real>(model.grid.ny);
    Real speed = std::sqrt(2 * model.gravity.norm() * reach) + settings.wind.velocity.norm();
    for (const Ball& ball : balls) speed += ball.velocity.norm();
    return speed;
}

std::string particle_name(const Grid& grid, Eigen::Index particle) {
    const int p = static_cast<int>(particle);
    return "particle " + std::to_string(p) + " (column " + std::to_string(p % grid.nx) + ", row " +
           std::to_string(p / grid.nx) + ")";
}

}  // namespace

std::string divergence(const Cloth& cloth, std::span<const Ball> balls, const Settings& settings) {
    const Points &x = cloth.state.x, &v = cloth.state.v;
    const auto n = static_cast<Real>(v.rows());

    // RMS speed against the mean motion: a long free fall is fast, but together
    const Vec3 mean = v.colwise().sum().transpose() / n;
    const Real square = v.squaredNorm() / n - mean.squaredNorm();
    const Real limit = margin * honest_speed(cloth, balls, settings);
    if (square <= limit * limit && std::isfinite(x.sum())) return {};

    // Name the first particle that is not finite, else the fastest
    Eigen::Index fastest = 0;
    Real largest = -1;
    for (Eigen::Index p = 0; p < v.rows(); ++p) {
        if (!x.row(p).allFinite() || !v.row(p).allFinite()) {
            return particle_name(cloth.model.grid, p) + " is no longer finite";
        }
        const Real speed = (v.row(p).transpose() - mean).squaredNorm();
        if (speed > largest) largest = speed, fastest = p;
    }
    return particle_name(cloth.model.grid, fastest) + " moves at " +
           real_text(static_cast<double>(std::sqrt(largest)), 3) + " m/s, which nothing in the scene explains,";
}

}  // namespace drape
