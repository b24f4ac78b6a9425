#include "drape/contact/solid_contacts.h"

#include <algorithm>
#include <cmath>

#include "contact_geometry.h"
#include "deepest_point.h"
#include "grid_features.h"
#include "tuning.h"

namespace drape {
namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const Points& x, const std::array<int, 3>& particles) {
    return {position(x, particles[0]), position(x, particles[1]), position(x, particles[2])};
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
struct TriangleNearSolid {
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
    const Points& before;  ///< the cloth when the planes were those of the contacts, n x 3 [m]
    const Points& x;       ///< at the end
    const Solid& solid;    ///< when the planes were those of the contacts
    Vec3 moved;            ///< by the solid since then [m]
    int number;
    Real thickness, reach;
    std::vector<Contact>& contacts;

    /// @param nearest the point of the cloth before
    void add(const TriangleNearSolid& beside, const DeepestPoint& nearest, bool of_particle) const {
        Contact contact;
        contact.ball = first_solid + number;
        contact.triangle = beside.triangle;
        contact.corners = beside.particles;
        contact.barycentric = nearest.barycentric;
        contact.of_particle = of_particle;
        contact.normal = nearest.surface.normal;
        const Real height = contact.normal.dot(nearest.point + moved) - nearest.surface.distance;
        contact.plane = {height, solid.moved, solid.velocity};
        contact.point = at_point(contact, x);
        contact.depth = height + thickness - contact.normal.dot(contact.point);
        if (contact.depth > -reach) contacts.push_back(contact);
    }

    void add_corner(const TriangleNearSolid& beside, std::size_t k) const {
        if (!(beside.surface[k].distance < thickness + reach)) return;
        DeepestPoint here{.barycentric = {}, .point = beside.corners[k], .surface = beside.surface[k]};
        here.barycentric[k] = 1;
        add(beside, here, true);
    }

    /// Adds the triangle's deepest point, or that of an edge which it reports.
    void add_inside(const TriangleNearSolid& beside) const {
        const Real least = std::min(thickness + reach, beside.lowest() - deeper_than_corners);
        if (beside.bound >= least) return;
        const DeepestPoint deepest = find_deepest_point(solid, beside.corners, beside.surface, least);
        if (!(deepest.surface.distance < least)) return;
        if (!reported_elsewhere(grid, beside.triangle, deepest.barycentric)) add(beside, deepest, false);
    }
};

/// Calls visit(beside) for each triangle of the cells.
template <class Visit>
void for_each_triangle_near(const ContactMaker& make, std::span<const CellRun> cells,
                            const std::vector<SurfaceDistance>& surface, Visit visit) {
    for (const CellRun& run : cells) {
        const int first = 2 * (run.row * make.grid.cell_columns() + run.column);
        for (int triangle = first; triangle < first + 2 * run.count; ++triangle) {
            TriangleNearSolid beside{triangle, make.grid.triangle_corners(triangle), {}, {}};
            beside.corners = corners_of(make.before, beside.particles);
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

/// A particle is measured again only if it may be as near as asked now, or be a corner of a triangle that may.
void SolidSearch::look_at_particles(const Grid& grid, const Points& x, const Solid& solid, int number, Real near,
                                    std::span<const CellRun> cells) {
    known_.resize(std::max(known_.size(), static_cast<std::size_t>(number) + 1));
    Known& known = known_[static_cast<std::size_t>(number)];
    const auto particles = static_cast<std::size_t>(grid.particles());
    if (known.shape != solid.shape || known.particles.size() != particles) {
        known = {solid.shape, std::vector<Measured>(particles)};
    }
    surface_.resize(particles);
    const Real far = near + longest_side(grid, x, cells) + deeper_than_corners;
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

void SolidSearch::find(const Grid& grid, const ClothMotion& cloth, const Solid& solid, int number, Real thickness,
                       Real reach, std::span<const CellRun> cells, std::vector<Contact>& contacts) {
    Solid start = solid;
    const Points& before = reach > 0 ? cloth.before : cloth.x;
    const Vec3 moved = reach > 0 ? solid.moved : Vec3(0, 0, 0);
    start.position -= moved;
    look_at_particles(grid, before, start, number, thickness + reach, cells);
    const ContactMaker make{grid, before, cloth.x, start, moved, number, thickness, reach, contacts};
    for_each_triangle_near(make, cells, surface_, [&](const TriangleNearSolid& beside, unsigned owned) {
        for (std::size_t k = 0; k < 3; ++k) {
            if ((owned >> k & 1u) != 0) make.add_corner(beside, k);
        }
        make.add_inside(beside);
    });
}

}  // namespace drape
