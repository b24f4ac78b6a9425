#include <algorithm>
#include <cmath>

#include "contact/grid_features.h"
#include "contact/tuning.h"
#include "deepest_point.h"
#include "make_row.h"

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
struct SolidContacts {
    const MovingCloth& cloth;
    const Points& before;      ///< the cloth when the planes were those of the contacts, n x 3 [m]
    const Solid &start, &end;  ///< the solid then, and at the end of the substep
    const SearchedBody& body;
    std::vector<ContactRow>& rows;

    /// @param nearest the point of the cloth before
    void add(ContactRow row, const DeepestPoint& nearest) const {
        row.normal = nearest.surface.normal;
        row.distance = body.thickness + row.normal.dot(nearest.point - start.position) - nearest.surface.distance;
        row.depth = row.distance - row.normal.dot(row.point(cloth.x) - end.position);
        if (row.depth > -body.reach) rows.push_back(row);
    }

    void add_corner(const TriangleNearSolid& beside, std::size_t k) const {
        if (!(beside.surface[k].distance < body.thickness + body.reach)) return;
        add(particle_row(cloth, beside.particles[k], beside.triangle, body.number),
            {.barycentric = {}, .point = beside.corners[k], .surface = beside.surface[k]});
    }

    /// Adds the triangle's deepest point, or that of an edge which it reports.
    void add_inside(const TriangleNearSolid& beside) const {
        const Real least = std::min(body.thickness + body.reach, beside.lowest() - deeper_than_corners);
        if (beside.bound >= least) return;
        const DeepestPoint deepest = find_deepest_point(start, beside.corners, beside.surface, least);
        if (!(deepest.surface.distance < least)) return;
        if (reported_elsewhere(cloth.grid, beside.triangle, deepest.barycentric)) return;
        add(triangle_row(cloth, beside.triangle, beside.particles, deepest.barycentric, body.number), deepest);
    }
};

/// Calls visit(beside, owned corners) for each triangle of the cells.
template <class Visit>
void for_each_triangle_near(const SolidContacts& make, std::span<const CellRun> cells,
                            const std::vector<SurfaceDistance>& surface, Visit visit) {
    const Grid& grid = make.cloth.grid;
    for (const CellRun& run : cells) {
        const int first = 2 * (run.row * grid.cell_columns() + run.column);
        for (int triangle = first; triangle < first + 2 * run.count; ++triangle) {
            TriangleNearSolid beside{triangle, grid.triangle_corners(triangle), {}, {}};
            beside.corners = corners_of(make.before, beside.particles);
            for (std::size_t k = 0; k < 3; ++k) {
                beside.surface[k] = surface[static_cast<std::size_t>(beside.particles[k])];
            }
            beside.set_bound(make.start.shape->is_convex());
            visit(beside, owned_corners(grid, triangle, run.row));
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

SolidSearch::Known& SolidSearch::known_of(int body, const Solid& solid, std::size_t particles) {
    auto known = std::ranges::find(known_, body, &Known::body);
    if (known == known_.end()) known = known_.insert(known, {.body = body, .shape = {}, .particles = {}});
    if (known->shape != solid.shape || known->particles.size() != particles) {
        *known = {body, solid.shape, std::vector<Measured>(particles)};
    }
    return *known;
}

/// A particle is measured again only if it may be as near as asked now, or be a corner of a triangle that may.
void SolidSearch::measure(const MovingCloth& cloth, const Solid& solid, int body, Real near,
                          std::span<const CellRun> cells) {
    const auto particles = static_cast<std::size_t>(cloth.grid.particles());
    Known& known = known_of(body, solid, particles);
    surface_.resize(particles);
    const Real far = near + longest_side(cloth.grid, cloth.x, cells) + deeper_than_corners;
    for_each_particle_once(cloth.grid, cells, particles_, [&](int particle) {
        const Vec3 p = position(cloth.x, particle), seen = p - solid.position;
        Measured& last = known.particles[static_cast<std::size_t>(particle)];
        SurfaceDistance& surface = surface_[static_cast<std::size_t>(particle)];
        surface = {last.distance - (seen - last.at).norm(), Vec3::Zero()};
        if (surface.distance > far) return;
        surface = solid.measure(p);
        last = {seen, surface.distance};
    });
}

void SolidSearch::find(const MovingCloth& cloth, const Solid& solid, const SearchedBody& body,
                       std::span<const CellRun> cells, std::vector<ContactRow>& rows) {
    Solid start = solid;
    if (body.reach > 0) start.position -= solid.moved;
    const Points& before = body.reach > 0 ? cloth.before : cloth.x;
    measure({cloth.grid, before, before}, start, body.number, body.thickness + body.reach, cells);
    const SolidContacts make{cloth, before, start, solid, body, rows};
    for_each_triangle_near(make, cells, surface_, [&](const TriangleNearSolid& beside, unsigned owned) {
        for (const std::size_t k : corners_ascending) {
            if ((owned >> k & 1u) != 0) make.add_corner(beside, k);
        }
        make.add_inside(beside);
    });
}

}  // namespace drape
