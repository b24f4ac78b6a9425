#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/grid_features.h"
#include "contact/kernels/near_cells.h"
#include "deepest_point.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/detection.h"

namespace drape {
namespace {

/// Calls visit(cell) for each cell of the ranges.
template <class Visit>
void for_each_cell(const Grid& grid, std::span<const CellRange> cells, Visit visit) {
    for (const CellRange& some : cells) {
        for_each_cell_of(some, [&](int i, int j) { visit(grid.cell(i, j)); });
    }
}

/// The same for those that may touch a ball: kernels leave out most of those that do not, plain code none.
/// @param p, radius of the ball, grown by the cloth's thickness
template <class Visit>
void for_each_cell_to_test(const Vec3& p, Real radius, const Grid& grid, const Points& x,
                           std::span<const CellRange> cells, Kernels kernels, Visit visit) {
    if (kernels == Kernels::Plain) return for_each_cell(grid, cells, visit);
    for (const CellRange& some : cells) kernels::for_each_near_cell(grid, x, p, radius, some, visit);
}

/// The corners of a triangle in the order of their numbers: those of a cell's first one are a, c, b.
constexpr std::array<std::size_t, 3> corners_ascending{0, 2, 1};

/// The contact of a particle, or of a point in a triangle or on an edge, with a body, without a plane yet.
/// @param triangle that reports it
/// @param particles one, or the corners of the triangle
template <std::size_t count>
ContactRow make_row(const MovingCloth& cloth, int triangle, const std::array<int, count>& particles,
                    const std::array<Real, count>& weights, int body) {
    ContactRow row;
    row.kind = count == 1 ? RowKind::Particle : RowKind::Triangle;
    row.count = row.first_count = count;
    row.triangle = triangle;
    row.body = body;
    for (std::size_t k = 0; k < count; ++k) row.particles[k] = {cloth.number, particles[k], weights[k]};
    return row;
}

/// From the centre of a ball to a point at some distance; along the triangle's own normal where that is the centre.
Vec3 normal_of(const Corners& corners, const Vec3& offset) {
    const Real distance = offset.norm();
    if (distance > 0) return offset / distance;
    const Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    return across.squaredNorm() > 0 ? Vec3(across.normalized()) : Vec3(0, 1, 0);
}

/// A triangle, where it was when the planes were those of the contacts.
struct Triangle {
    int number;
    std::array<int, 3> particles;
    Corners corners;
};

/// A ball as triangles are near it.
struct NearBall {
    Vec3 centre;  ///< where the planes are those of the contacts [m]
    Real radius;

    /// The surface next to a corner; nothing if it is not as near as a limit.
    [[nodiscard]] std::optional<SurfaceDistance> at_corner(const Triangle& triangle, std::size_t k, Real limit) const {
        if (!is_near(triangle.corners[k], limit)) return std::nullopt;
        return surface(triangle, triangle.corners[k]);
    }

    /// The same next to the point of a triangle that is nearest.
    [[nodiscard]] std::optional<DeepestPoint> nearest(const Triangle& triangle, Real limit) const {
        const auto& [a, b, c] = triangle.corners;
        const ClosestPoint closest = closest_point_on_triangle(centre, a, b, c);
        if (!is_near(closest.point, limit)) return std::nullopt;
        return DeepestPoint{closest.barycentric, closest.point, surface(triangle, closest.point)};
    }

private:
    [[nodiscard]] bool is_near(const Vec3& point, Real limit) const {
        const Real far = radius + limit;
        return (point - centre).squaredNorm() < far * far;
    }
    [[nodiscard]] SurfaceDistance surface(const Triangle& triangle, const Vec3& point) const {
        const Vec3 offset = point - centre;
        return {offset.norm() - radius, normal_of(triangle.corners, offset)};
    }
};

/// A solid as triangles are near it.
struct NearSolid {
    const Solid& solid;                          ///< where the planes are those of the contacts
    std::vector<SurfaceDistance>& surface;       ///< of the particles that were asked for, else no number
    std::vector<SolidSearch::Measured>& before;  ///< of all triangles, whenever they were last measured

    [[nodiscard]] std::optional<SurfaceDistance> at_corner(const Triangle& triangle, std::size_t k, Real limit) const {
        const SurfaceDistance& corner = known(triangle, k);
        return corner.distance < limit ? std::optional(corner) : std::nullopt;
    }

    /// Nothing, without being measured, too, if the triangle cannot have come near enough since it was.
    [[nodiscard]] std::optional<DeepestPoint> nearest(const Triangle& triangle, Real limit) const {
        auto& [corners, distance] = before[static_cast<std::size_t>(triangle.number)];
        Real moved = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            moved = std::max(moved, (triangle.corners[k] - solid.position - corners[k]).squaredNorm());
        }
        if (distance - std::sqrt(moved) > limit) return std::nullopt;
        const std::array at_corners{known(triangle, 0), known(triangle, 1), known(triangle, 2)};
        const NearestPoint found = find_nearest_point(solid, triangle.corners, at_corners, limit);
        for (std::size_t k = 0; k < 3; ++k) corners[k] = triangle.corners[k] - solid.position;
        distance = found.bound;
        return found.point;
    }

private:
    /// Measured once.
    [[nodiscard]] const SurfaceDistance& known(const Triangle& triangle, std::size_t k) const {
        SurfaceDistance& at = surface[static_cast<std::size_t>(triangle.particles[k])];
        if (std::isnan(at.distance)) at = solid.measure(triangle.corners[k]);
        return at;
    }
};

/// Makes the contacts of the triangles of a cloth with a body.
template <class NearBody>
struct BodyContacts {
    const MovingCloth& cloth;
    const SearchedBody& body;
    NearBody near;
    Vec3 start, end;  ///< of a point of the body: where the planes are those of the contacts, and at the end
    std::vector<ContactRow>& rows;

    const Points& before = body.reach > 0 ? cloth.before : cloth.x;

    /// Adds the contacts that a triangle is to report: those of its own corners, and of its nearest point.
    /// @return whether it touches
    bool add_triangle(int number) {
        const Grid& grid = cloth.grid;
        Triangle triangle{number, grid.triangle_corners(number), {}};
        for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = position(before, triangle.particles[k]);
        const Real limit = body.thickness + body.reach;
        const auto nearest = near.nearest(triangle, limit);
        if (!nearest) return false;
        for (const std::size_t k : corners_ascending) {
            if (owner_of(grid, triangle.particles[k]) != number) continue;
            const auto corner = near.at_corner(triangle, k, limit);
            if (!corner) continue;
            add(with_plane(make_row<1>(cloth, number, {triangle.particles[k]}, {1}, body.number), triangle.corners[k],
                           *corner));
        }
        const ContactRow own =
            with_plane(make_row(cloth, number, triangle.particles, nearest->barycentric, body.number), nearest->point,
                       nearest->surface);
        if (!reported_elsewhere(grid, number, nearest->barycentric)) add(own);
        return own.depth > 0;
    }

private:
    [[nodiscard]] ContactRow with_plane(ContactRow row, const Vec3& at, const SurfaceDistance& surface) const {
        row.normal = surface.normal;
        row.distance = body.thickness + row.normal.dot(at - start) - surface.distance;
        row.depth = row.distance - row.normal.dot(row.point(cloth.x) - end);
        return row;
    }

    /// What ends farther from its plane than the body may push other cloth to it stays out of the solve.
    void add(const ContactRow& row) {
        if (row.depth > -body.reach) rows.push_back(row);
    }
};

}  // namespace

void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRange> cells, std::vector<int>& triangles, Kernels kernels) {
    const Real radius = ball.radius + thickness;
    const auto is_inside = [&](const Vec3& p) { return (p - ball.centre).squaredNorm() <= radius * radius; };
    const auto touches = [&](const std::array<int, 3>& corners) {
        return is_inside(closest_point(x, corners, ball.centre).point);
    };
    const auto test = [&](int cell) {
        const auto first = grid.triangle_corners(2 * cell), second = grid.triangle_corners(2 * cell + 1);
        // Most are decided by a corner, and by one that both have
        const bool both = is_inside(position(x, second[0])) || is_inside(position(x, second[1]));
        if (both || is_inside(position(x, first[0])) || touches(first)) triangles.push_back(2 * cell);
        if (both || is_inside(position(x, second[2])) || touches(second)) triangles.push_back(2 * cell + 1);
    };
    triangles.clear();
    for_each_cell_to_test(ball.centre, radius, grid, x, cells, kernels, test);
}

std::int64_t find_contacts(const MovingCloth& cloth, const Ball& ball, const SearchedBody& body,
                           std::span<const CellRange> cells, std::vector<ContactRow>& rows, Kernels kernels) {
    const Vec3 start = body.reach > 0 ? Vec3(ball.centre - ball.moved) : ball.centre;
    BodyContacts<NearBall> found{cloth, body, {start, ball.radius}, start, ball.centre, rows};
    std::int64_t touching = 0;
    const auto test = [&](int cell) {
        const bool first = found.add_triangle(2 * cell), second = found.add_triangle(2 * cell + 1);
        touching += first || second;
    };
    const Real far = ball.radius + (body.thickness + body.reach);
    for_each_cell_to_test(start, far, cloth.grid, found.before, cells, kernels, test);
    return touching;
}

void SolidSearch::find(const MovingCloth& cloth, const Solid& solid, const SearchedBody& body,
                       std::span<const CellRange> cells, std::vector<ContactRow>& rows) {
    if (cells.empty()) return;
    const SurfaceDistance unknown{std::numeric_limits<Real>::quiet_NaN(), Vec3::Zero()};
    surface_.assign(static_cast<std::size_t>(cloth.grid.particles()), unknown);
    const auto triangles = static_cast<std::size_t>(cloth.grid.triangles());
    Known& known = known_[body.number];
    if (known.shape != solid.shape || known.triangles.size() != triangles) {
        known = {solid.shape, std::vector<Measured>(triangles)};
    }
    Solid start = solid;
    if (body.reach > 0) start.position -= solid.moved;
    BodyContacts<NearSolid> found{cloth,          body,           {start, surface_, known.triangles},
                                  start.position, solid.position, rows};
    for_each_cell(cloth.grid, cells, [&](int cell) {
        for (const int triangle : {2 * cell, 2 * cell + 1}) found.add_triangle(triangle);
    });
}

void find_ground_contacts(const MovingCloth& cloth, Real height, const SearchedBody& body,
                          std::span<const CellRange> cells, std::vector<ContactRow>& rows) {
    const Grid& grid = cloth.grid;
    const Real limit = height + body.thickness;
    const auto add = [&](int particle) {
        if (!(cloth.x(particle, 1) < limit)) return;
        ContactRow row = make_row<1>(cloth, owner_of(grid, particle), {particle}, {1}, body.number);
        row.normal = Vec3(0, 1, 0);
        row.distance = body.thickness;
        row.depth = limit - cloth.x(particle, 1);
        rows.push_back(row);
    };
    for (const CellRange& some : cells) {
        for_each_cell_of(some, [&](int i, int j) { for_each_particle_of(grid, i, j, add); });
    }
}

void find_node_contacts(const MovingCloth& cloth, const Ball& ball, const SearchedBody& body, Real longest_push,
                        std::span<const StoppedNode> nodes, std::vector<ContactRow>& rows) {
    for (const StoppedNode& node : nodes) {
        constexpr Real third = Real(1) / 3;
        const std::array<int, 3> corners = cloth.grid.triangle_corners(2 * node.cell);
        ContactRow row = make_row(cloth, 2 * node.cell, corners, {third, third, third}, body.number);
        row.kind = RowKind::Node;
        const auto [a, b, c] = corners;
        row.normal = normal_of({position(cloth.x, a), position(cloth.x, b), position(cloth.x, c)},
                               node.sphere.centre - ball.centre);
        const Real radii = ball.radius + body.thickness + node.sphere.radius;
        const Real depth = radii - (node.sphere.centre - ball.centre).dot(row.normal);
        if (!(depth > 0)) continue;
        row.depth = std::min(depth, longest_push);
        row.distance = row.depth + (row.point(cloth.x) - ball.centre).dot(row.normal);
        rows.push_back(row);
    }
}

}  // namespace drape
