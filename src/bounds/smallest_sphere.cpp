#include "smallest_sphere.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace drape {
namespace {

/// In space, four points determine a sphere: a support never has more.
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

/// The centre, in their line, plane or space, of the sphere through up to four points; none where one of them is in the
/// line or plane of the others. Point by point, the centre moves at right angles to all earlier points until the next
/// one is as far as they are. @cite gaertner1999
std::optional<Vec3> circumcentre(const Points5& points) {
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Vec3& origin = points[0];
    Vec3 centre = Vec3::Zero();   // from the origin
    Vec3 sides[largest_support];  // at right angles to one another
    for (int k = 1; k < points.count; ++k) {
        const Vec3 point = points[k] - origin;
        Vec3& side = sides[k];
        side = point;
        for (int j = 1; j < k; ++j) side -= side.dot(sides[j]) / sides[j].squaredNorm() * sides[j];
        const Real square = side.squaredNorm();
        if (!(square > epsilon * epsilon * point.squaredNorm())) return std::nullopt;
        centre += point.dot(point - 2 * centre) / (2 * square) * side;
    }
    return origin + centre;
}

struct SupportedSphere {
    Vec3 centre;
    Real square;  ///< of the radius, to the farthest of the points that it is about
    Points5 support;
};

/// The smallest sphere about a point and the support of another sphere, with the point on it: of all spheres through
/// the point and some of the support, the one that is smallest once it is grown to all of them.
/// Choosing by measure lets it pass over points that (nearly) coincide or are in one line, plane or circle.
SupportedSphere smallest_with(const Vec3& point, const Points5& others) {
    SupportedSphere best{point, others.farthest_square(point), {}};
    best.support.add(point);
    for (unsigned chosen = 1; chosen < 1u << others.count; ++chosen) {
        Points5 support;
        support.add(point);
        for (int k = 0; k < others.count; ++k) {
            if (chosen & 1u << k) support.add(others[k]);
        }
        if (support.count > largest_support) continue;
        const std::optional<Vec3> centre = circumcentre(support);
        if (!centre) continue;
        const Real square = std::max(others.farthest_square(*centre), (point - *centre).squaredNorm());
        if (square < best.square) best = {*centre, square, support};
    }
    return best;
}

}  // namespace

Vec3 smallest_sphere_centre(const Patch& patch, FindFarthest find_farthest) {
    constexpr Real rounding = 8 * std::numeric_limits<Real>::epsilon();
    constexpr int patience = 16;  // passes in which rounding may hide that the sphere gets better

    SupportedSphere sphere{patch.at(0, 0), 0, {}};
    Vec3 best = sphere.centre;
    Real least = std::numeric_limits<Real>::max(), largest = 0;  // the smallest sphere's radius is between, squared
    for (int waited = 0; waited < patience; ++waited) {
        const Vec3 farthest = find_farthest(patch, sphere.centre);
        const Real square = (farthest - sphere.centre).squaredNorm();
        if (square < least) least = square, best = sphere.centre, waited = 0;
        if (square <= sphere.square * (1 + rounding)) break;
        sphere = smallest_with(farthest, sphere.support);
        if (sphere.square > largest) largest = sphere.square, waited = 0;
    }
    return best;
}

}  // namespace drape
