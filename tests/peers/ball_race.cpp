#include "ball_race.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/detection.h"

namespace drape::peers {
namespace {

/// A square sheet of side 1 in waves, and a ball in its middle that cuts a tenth of it out.
struct CutSheet {
    Grid grid;
    Points x;
    Ball ball;

    explicit CutSheet(int side) : grid{side, side}, x(grid.particles(), 3) {
        ball.radius = std::sqrt(Real(0.1) / std::numbers::pi_v<Real>);
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const Real u = static_cast<Real>(i) / static_cast<Real>(side - 1) - Real(0.5);
                const Real w = static_cast<Real>(j) / static_cast<Real>(side - 1) - Real(0.5);
                x.row(grid.particle(i, j)) << u, Real(0.05) * std::sin(9 * u) * std::cos(7 * w), w;
            }
        }
    }
};

/// From a point to the closest one of a triangle.
Vec3 offset(const Points& x, const std::array<int, 3>& corners, const Vec3& p) {
    const auto at = [&x](int particle) -> Vec3 { return x.row(particle).transpose(); };
    return closest_point_on_triangle(p, at(corners[0]), at(corners[1]), at(corners[2])).point - p;
}

Real rounding_about(const Ball& ball, Real epsilon) {
    return 16 * epsilon * (ball.centre.cwiseAbs().sum() + ball.radius);
}

}  // namespace

Motion::Motion(int side, int count) {
    const CutSheet sheet(side);
    grid = sheet.grid;
    for (int t = 0; t < grid.triangles(); ++t) corners.push_back(grid.triangle_corners(t));
    const std::vector<CellRange> all{all_cells(grid)};
    frames.reserve(static_cast<std::size_t>(count));
    for (int f = 0; f < count; ++f) {
        const Real phase = 2 * std::numbers::pi_v<Real> * static_cast<Real>(f) / static_cast<Real>(count);
        Frame frame{sheet.x, sheet.ball, {}};
        for (int p = 0; p < grid.particles(); ++p) {
            const Real u = sheet.x(p, 0), w = sheet.x(p, 2);
            frame.x(p, 0) += Real(0.005) * std::cos(9 * u - phase);
            frame.x(p, 1) = Real(0.05) * std::sin(9 * u - phase) * std::cos(7 * w);
            frame.x(p, 2) += Real(0.005) * std::sin(7 * w + phase);
        }
        frame.ball.centre +=
            Vec3(Real(0.15) * std::cos(phase), Real(0.03) * std::sin(2 * phase), Real(0.15) * std::sin(phase));
        find_touched_triangles(grid, frame.x, frame.ball, 0, all, frame.touched, Kernels::Vector);
        frames.push_back(std::move(frame));
    }
}

BallMethod::BallMethod(std::string name, const Motion& motion)
    : Runner(std::move(name), motion.frames.size()), motion_(motion), x_(motion.frames.back().x) {}

void BallMethod::prepare(std::size_t frame) {
    x_ = motion_.frames[frame].x;
    ball_ = motion_.frames[frame].ball;
}

/// Triangles that brute force or the method alone finds must be within rounding of touching.
int BallMethod::check(std::size_t frame) {
    const std::vector<int>& expected = motion_.frames[frame].touched;
    std::ranges::sort(touched_);
    std::vector<int> different;
    std::ranges::set_symmetric_difference(expected, touched_, std::back_inserter(different));
    for (const int triangle : different) {
        const auto& corners = motion_.corners[static_cast<std::size_t>(triangle)];
        const Real gap = offset(x_, corners, ball_.centre).norm() - ball_.radius;
        if (std::abs(gap) <= rounding_about(ball_, std::numeric_limits<Real>::epsilon())) continue;
        throw RunError("triangle " + std::to_string(triangle) + ", " + real_text(static_cast<double>(gap), 3) +
                       " m off the ball's surface, is in one of the sets only (found " +
                       std::to_string(touched_.size()) + " triangles, brute force " + std::to_string(expected.size()) +
                       ")");
    }
    return static_cast<int>(different.size());
}

/// Most candidates are decided by a corner within reach, as in `find_touched_triangles`.
void BallPeer::query() {
    touched_.clear();
    list_candidates(grown(ball_, rounding_about(ball_, epsilon_)), touched_);
    const Vec3& p = ball_.centre;
    const Real square = ball_.radius * ball_.radius;
    const Real *const xs = x_.col(0).data(), *const ys = x_.col(1).data(), *const zs = x_.col(2).data();
    std::erase_if(touched_, [&](int triangle) {
        const auto corners = motion_.grid.triangle_corners(triangle);
        for (const int c : corners) {
            const Real dx = xs[c] - p[0], dy = ys[c] - p[1], dz = zs[c] - p[2];
            if (dx * dx + dy * dy + dz * dz <= square) return false;
        }
        return offset(x_, corners, p).squaredNorm() > square;
    });
}

}  // namespace drape::peers
