#pragma once

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "drape/base/real.h"

namespace drape {

/// How a point lies to a surface.
struct SurfaceDistance {
    Real distance = 0;           ///< to the nearest point of the surface, less than zero inside [m]
    Vec3 normal = Vec3::Zero();  ///< the direction in which the distance grows, length 1
};

/// A closed surface as triangles, counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> points;   ///< [m]
    std::vector<Vec3> normals;  ///< one a point, length 1; to draw with
    std::vector<std::array<int, 3>> triangles;
};

/// A straight piece of a line, by its ends [m].
using Segment = std::array<Vec3, 2>;

/// A rigid shape about its own origin.
class SolidShape {
public:
    virtual ~SolidShape() = default;

    [[nodiscard]] virtual SurfaceDistance measure(const Vec3& p) const = 0;

    /// A distance that no point of a triangle is below, at most `asked`; minus infinity where a shape has none.
    /// @param triangle of which the corners are outside, no nearer than `asked`
    /// @par Cost O(log triangles) and some microseconds near the surface
    [[nodiscard]] virtual Real clearance(const std::array<Vec3, 3>& /*triangle*/, Real /*asked*/) const {
        return -std::numeric_limits<Real>::infinity();
    }

    /// Whether the signed distance is a convex function: then what is lowest nearby is lowest of all.
    [[nodiscard]] virtual bool is_convex() const = 0;

    /// What of a convex shape a triangle may be nearest to other than with a corner: the sides of a box, the axis of a
    /// capsule.
    [[nodiscard]] virtual std::span<const Segment> ridges() const { return {}; }

    /// The lowest and the highest corner of a box about it [m]
    [[nodiscard]] virtual std::array<Vec3, 2> extent() const = 0;

    /// What is drawn.
    [[nodiscard]] virtual TriangleMesh surface() const = 0;
};

/// @param size along its three axes [m]
std::shared_ptr<const SolidShape> make_box(const Vec3& size);

/// All points within `radius` of a segment of the y axis.
/// @param length of the segment [m]
std::shared_ptr<const SolidShape> make_capsule(Real radius, Real length);

/// The inside of a closed surface. The sign comes from angle-weighted normals. @cite baerentzen2005
/// @param mesh closed, oriented and without triangles of zero area; its normals are replaced by smooth ones
/// @par Cost of a distance O(log triangles) near the surface
std::shared_ptr<const SolidShape> make_mesh_shape(TriangleMesh mesh);

}  // namespace drape
