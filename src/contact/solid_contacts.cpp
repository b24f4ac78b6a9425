#include "drape/contact/solid_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "advance.h"
#include "contact_geometry.h"
#include "drape/contact/deepest_point.h"
#include "grid_features.h"

namespace drape {
namespace {

using Corners = std::array<Vec3, 3>;

/// A triangle's own point counts where it is deeper than its corners by this [m]: on a flat side it is as deep.
constexpr Real deeper_than_corners = Real(1e-5);

Corners corners_of(const Points& x, const std::array<int, 3>& particles) {
    return {position(x, particles[0]), position(x, particles[1]), position(x, particles[2])};
}

Corners moved_by(Corners corners, const Vec3& way) {
    for (Vec3& corner : corners) corner += way;
    return corners;
}

bool is_corner(const std::array<Real, 3>& weights) { return feature_at(weights).zeros == 2; }

/// The deepest point at a moment of a way; of a particle, itself.
DeepestPoint deepest_at(const Solid& solid, const Corners& from, const Corners& to, Real t, bool of_particle) {
    Corners corners;
    std::array<SurfaceDistance, 3> surface;
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = from[k] + t * (to[k] - from[k]);
        if (k == 0 || !of_particle) surface[k] = solid.measure(corners[k]);
    }
    if (of_particle) return {{1, 0, 0}, corners[0], surface[0]};
    return find_deepest_point(solid, corners, surface);
}

/// The first point to come within the thickness, on a way that is seen from the solid.
/// @param bound no point is nearer than this at the end [m]
std::optional<DeepestPoint> first_touch(const Solid& solid, const Corners& from, const Corners& to, Real bound,
                                        Real thickness, bool of_particle) {
    const Real near = std::max(thickness, touch_distance);
    Real longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (to[k] - from[k]).norm());
    if (bound - longest > near) return std::nullopt;  // no point is farther from its end than that
    DeepestPoint met;
    const auto measure = [&](Real t) -> Advance {
        met = deepest_at(solid, from, to, t, of_particle);
        return {met.surface.distance, t + (met.surface.distance - near / 2) / longest};
    };
    return first_time(measure, near) ? std::optional(met) : std::nullopt;
}

/// No point of a triangle is farther than this from the nearest corner: in one without an obtuse angle the radius of
/// the circle through all three, else no more than half of the longest side [m].
Real covering_radius(const Corners& corners) {
    std::array<Real, 3> squares;
    for (std::size_t k = 0; k < 3; ++k) squares[k] = (corners[k] - corners[(k + 1) % 3]).squaredNorm();
    std::ranges::sort(squares);
    const auto [a, b, c] = squares;
    // Twice the product of the two shorter sides and the cosine between them; 16 area^2 = 4 a b - acute^2
    const Real acute = a - (c - b);
    if (!(acute > 0)) return std::sqrt(c) / 2;
    return std::sqrt(c / (4 - (acute / a) * (acute / b)));
}

/// A triangle of the cloth beside a solid.
struct TriangleBeside {
    int triangle = 0;
    std::array<int, 3> particles{};
    Corners corners;
    std::array<SurfaceDistance, 3> surface;  ///< of the corners
    Real bound = 0;                          ///< no point of the triangle is nearer than this [m]

    [[nodiscard]] Real lowest() const { return std::ranges::min(surface, {}, &SurfaceDistance::distance).distance; }

    /// Sets the bound from the triangle's size and, where the distance is convex, from its gradients at the corners.
    void set_bound(bool is_convex) {
        bound = lowest() - covering_radius(corners);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 first = corners[k] - corners[(k + 1) % 3], second = corners[k] - corners[(k + 2) % 3];
            const Vec3& normal = surface[k].normal;
            const bool has_slope = is_convex && !normal.isZero(0);
            const Real fall = has_slope ? std::max({normal.dot(first), normal.dot(second), Real(0)})
                                        : std::max(first.norm(), second.norm());
            bound = std::max(bound, surface[k].distance - fall);
        }
    }
};

/// Makes contacts of one cloth with one solid.
struct ContactMaker {
    const Grid& grid;
    const Points& x;
    const Solid& solid;
    int number;
    Real thickness;

    /// @param met the point of the cloth, or where it was on its way: the plane is that of the surface next to it
    [[nodiscard]] Contact contact(const TriangleBeside& beside, const DeepestPoint& met) const {
        Contact contact;
        contact.ball = first_solid + number;
        contact.triangle = beside.triangle;
        contact.corners = beside.particles;
        contact.barycentric = met.barycentric;
        contact.normal = met.surface.normal;
        contact.plane = {met.surface.normal.dot(met.point) - met.surface.distance, solid.moved, solid.velocity};
        contact.point = at_point(contact, x);
        contact.depth = contact.plane.height + thickness - contact.normal.dot(contact.point);
        return contact;
    }

    [[nodiscard]] std::optional<Contact> of_corner(const TriangleBeside& beside, std::size_t k) const {
        if (!(beside.surface[k].distance < thickness)) return std::nullopt;
        DeepestPoint here{.barycentric = {}, .point = beside.corners[k], .surface = beside.surface[k]};
        here.barycentric[k] = 1;
        Contact found = contact(beside, here);
        found.of_particle = true;
        return found;
    }

    /// Of the triangle's deepest point, or of that of an edge which it reports.
    [[nodiscard]] std::optional<Contact> of_inside(const TriangleBeside& beside) const {
        const Real least = std::min(thickness, beside.lowest() - deeper_than_corners);
        if (beside.bound >= least) return std::nullopt;
        const DeepestPoint deepest = find_deepest_point(solid, beside.corners, beside.surface, least);
        if (!(deepest.surface.distance < least)) return std::nullopt;
        if (reported_elsewhere(grid, beside.triangle, deepest.barycentric)) return std::nullopt;
        return contact(beside, deepest);
    }

    /// What has passed, or has come to another side, has the plane at which it met the solid; all else stays.
    /// @param before positions at the start, n x 3 [m]
    /// @param corner of a particle; 3: of the triangle
    [[nodiscard]] std::optional<Contact> on_its_side(const Points& before, const TriangleBeside& beside,
                                                     std::size_t corner, std::optional<Contact> at_end) const {
        Corners from = moved_by(corners_of(before, beside.particles), solid.moved), to = beside.corners;
        const bool of_particle = corner < 3;
        if (of_particle) from.fill(Vec3(from[corner])), to.fill(Vec3(to[corner]));
        const Real bound = of_particle ? beside.surface[corner].distance : beside.bound;
        auto met = first_touch(solid, from, to, bound, thickness, of_particle);
        if (!met || (!of_particle && is_corner(met->barycentric))) return at_end;
        if (at_end && met->surface.normal.dot(at_end->normal) >= same_side) return at_end;
        if (of_particle) met->barycentric = {}, met->barycentric[corner] = 1;
        Contact passed = contact(beside, *met);
        passed.of_particle = of_particle;
        passed.of_impact = true;
        return passed.depth > 0 ? std::optional(passed) : std::nullopt;
    }
};

/// Calls visit(beside) for each triangle of the cells.
template <class Visit>
void for_each_beside(const ContactMaker& make, std::span<const CellRun> cells,
                     const std::vector<SurfaceDistance>& surface, Visit visit) {
    for (const CellRun& run : cells) {
        const int first = 2 * (run.row * make.grid.cell_columns() + run.column);
        for (int triangle = first; triangle < first + 2 * run.count; ++triangle) {
            TriangleBeside beside{triangle, make.grid.triangle_corners(triangle), {}, {}};
            beside.corners = corners_of(make.x, beside.particles);
            for (std::size_t k = 0; k < 3; ++k) {
                beside.surface[k] = surface[static_cast<std::size_t>(beside.particles[k])];
            }
            beside.set_bound(make.solid.shape->is_convex());
            visit(beside, owned_corners(make.grid, triangle, run.row));
        }
    }
}

/// Calls visit(particle) for each corner of the cells, once.
/// @param runs scratch
template <class Visit>
void for_each_particle_once(const Grid& grid, std::span<const CellRun> cells, std::vector<CellRun>& runs, Visit visit) {
    list_corners(cells, runs);
    int done = 0;
    for (const CellRun& run : runs) {
        const int first = grid.particle(run.column, run.row), end = first + run.count;
        for (int particle = std::max(first, done); particle < end; ++particle) visit(particle);
        done = std::max(done, end);
    }
}

/// The longest side of any triangle of the cells [m]
Real longest_side(const Grid& grid, const Points& x, std::span<const CellRun> cells) {
    Real square = 0;
    for (const CellRun& run : cells) {
        for (int column = run.column; column < run.column + run.count; ++column) {
            const int a = grid.particle(column, run.row), c = grid.particle(column, run.row + 1);
            for (const auto& [from, to] : {std::pair(a, a + 1), {a, c}, {a + 1, c}, {a + 1, c + 1}, {c, c + 1}}) {
                square = std::max(square, (x.row(from) - x.row(to)).squaredNorm());
            }
        }
    }
    return std::sqrt(square);
}

}  // namespace

/// A particle is measured again only if it may be within the thickness now, or be a corner of a triangle that may.
void SolidSearch::look_at_particles(const Grid& grid, const Points& x, const Solid& solid, int number, Real thickness,
                                    std::span<const CellRun> cells) {
    known_.resize(std::max(known_.size(), static_cast<std::size_t>(number) + 1));
    Known& known = known_[static_cast<std::size_t>(number)];
    const auto particles = static_cast<std::size_t>(grid.particles());
    if (known.shape != solid.shape || known.particles.size() != particles) {
        known = {solid.shape, std::vector<Measured>(particles)};
    }
    surface_.resize(particles);
    const Real far = thickness + longest_side(grid, x, cells) + deeper_than_corners;
    for_each_particle_once(grid, cells, particles_, [&](int particle) {
        const Vec3 p = position(x, particle), seen = p - solid.position;
        Measured& last = known.particles[static_cast<std::size_t>(particle)];
        SurfaceDistance& surface = surface_[static_cast<std::size_t>(particle)];
        surface = {last.distance - (seen - last.at).norm(), Vec3::Zero()};
        if (surface.distance > far) return;
        surface = solid.measure(p);
        last = {seen, surface.distance};
    });
}

void SolidSearch::find(const Grid& grid, const Points& x, const Solid& solid, int number, Real thickness,
                       std::span<const CellRun> cells, std::vector<Contact>& contacts) {
    look_at_particles(grid, x, solid, number, thickness, cells);
    const ContactMaker make{grid, x, solid, number, thickness};
    for_each_beside(make, cells, surface_, [&](const TriangleBeside& beside, unsigned owned) {
        for (std::size_t k = 0; k < 3; ++k) {
            if ((owned >> k & 1u) == 0) continue;
            if (const auto found = make.of_corner(beside, k)) contacts.push_back(*found);
        }
        if (const auto found = make.of_inside(beside)) contacts.push_back(*found);
    });
}

void SolidSearch::find_swept(const Grid& grid, const Points& before, const Points& x, const Solid& solid, int number,
                             Real thickness, std::span<const CellRun> cells, std::vector<Contact>& contacts) {
    look_at_particles(grid, x, solid, number, thickness, cells);
    const ContactMaker make{grid, x, solid, number, thickness};
    for_each_beside(make, cells, surface_, [&](const TriangleBeside& beside, unsigned owned) {
        std::array<std::optional<Contact>, 4> found;
        for (std::size_t k = 0; k < 3; ++k) {
            if ((owned >> k & 1u) != 0) found[k] = make.on_its_side(before, beside, k, make.of_corner(beside, k));
        }
        found[3] = make.on_its_side(before, beside, 3, make.of_inside(beside));
        for (const bool of_impact : {false, true}) {
            for (const auto& one : found) {
                if (one && one->of_impact == of_impact) contacts.push_back(*one);
            }
        }
    });
}

}  // namespace drape
