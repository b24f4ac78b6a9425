#include "smallest_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "extreme_kernels.h"

namespace drape {
namespace {

/// Two to the number of dimensions and one more: a support never has more particles.
constexpr int largest_support = 4;

/// A few points, without the heap.
struct Points5 {
    std::array<Vec3, largest_support + 1> point;
    int count = 0;

    void add(const Vec3& p) { point[at(count++)] = p; }
    [[nodiscard]] const Vec3& operator[](int k) const { return point[at(k)]; }

    [[nodiscard]] Real farthest_square(const Vec3& centre) const {
        Real square = 0;
        for (int k = 0; k < count; ++k) square = std::max(square, (point[at(k)] - centre).squaredNorm());
        return square;
    }

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
};

/// The sphere through up to four points whose centre is in their plane, line or space.
struct Circumsphere {
    Vec3 centre;
    Real smallest_weight;  ///< of a point, if the centre is written as their weighted mean; NaN if there is no sphere
};

/// Point by point: the centre moves at right angles to all earlier points until the next one is as far as they are.
/// @cite gaertner1999
Circumsphere circumsphere(const Points5& points) {
    constexpr auto none = std::numeric_limits<Real>::quiet_NaN();
    const Vec3& origin = points[0];
    Vec3 centre = Vec3::Zero();  // from the origin
    Vec3 side[largest_support];  // at right angles to one another
    Real share[largest_support][largest_support];
    Real move[largest_support];
    for (int k = 1; k < points.count; ++k) {
        const Vec3 point = points[k] - origin;
        side[k] = point;
        for (int j = 1; j < k; ++j) {
            share[k][j] = side[k].dot(side[j]) / side[j].squaredNorm();
            side[k] -= share[k][j] * side[j];
        }
        const Real square = side[k].squaredNorm();
        if (!(square > 0)) return {origin, none};
        move[k] = point.dot(point - 2 * centre) / (2 * square);
        centre += move[k] * side[k];
    }

    // The moves along the sides, written as weights of the points
    Real first = 1, least = 1;
    for (int k = points.count - 1; k > 0; --k) {
        for (int j = 1; j < k; ++j) move[j] -= share[k][j] * move[k];
        first -= move[k];
        least = std::min(least, move[k]);
    }
    return {origin + centre, std::min(least, first)};
}

struct SupportedSphere {
    Vec3 centre;
    Real square;  ///< of the radius, to the farthest of the points that it is about
    Points5 support;
};

/// The smallest sphere about a point and the support of another sphere, with the point on it: of all spheres through
/// the point and some of the support, centred among those, the one that is smallest once it reaches all of them.
/// Choosing by measure lets it pass over points that are (nearly) in one place, line, plane or circle.
SupportedSphere smallest_with(const Vec3& point, const Points5& others) {
    const Real nearly_none = std::sqrt(std::numeric_limits<Real>::epsilon());
    SupportedSphere best{point, others.farthest_square(point), {}};
    best.support.add(point);
    for (unsigned chosen = 1; chosen < 1u << others.count; ++chosen) {
        Points5 support;
        support.add(point);
        for (int k = 0; k < others.count; ++k) {
            if (chosen & 1u << k) support.add(others[k]);
        }
        if (support.count > largest_support) continue;
        const Circumsphere through = circumsphere(support);
        if (!(through.smallest_weight >= -nearly_none)) continue;
        const Real square = std::max(others.farthest_square(through.centre), (point - through.centre).squaredNorm());
        if (square < best.square) best = {through.centre, square, support};
    }
    return best;
}

}  // namespace

Vec3 smallest_sphere_centre(const Patch& patch) {
    constexpr Real rounding = 8 * std::numeric_limits<Real>::epsilon();
    constexpr int patience = 16;  // passes in which rounding may hide that the sphere gets better

    SupportedSphere sphere{patch.at(0, 0), 0, {}};
    Vec3 best = sphere.centre;
    Real reached = std::numeric_limits<Real>::max(), largest = 0;  // the smallest sphere's radius is between, squared
    for (int waited = 0; waited < patience; ++waited) {
        const Vec3 farthest = particle(patch, kernels::farthest_particle(patch, sphere.centre));
        const Real square = (farthest - sphere.centre).squaredNorm();
        if (square < reached) reached = square, best = sphere.centre, waited = 0;
        if (square <= sphere.square * (1 + rounding)) break;
        sphere = smallest_with(farthest, sphere.support);
        if (sphere.square > largest) largest = sphere.square, waited = 0;
    }
    return best;
}

}  // namespace drape
