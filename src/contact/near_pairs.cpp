#include "drape/contact/near_pairs.h"

#include <algorithm>
#include <span>

#include "contact_geometry.h"
#include "drape/contact/segments.h"
#include "grid_features.h"

namespace drape {
namespace {

/// An edge and its box.
struct CellEdge {
    std::array<int, 2> ends;
    Aabb box;
};

/// The particles and the edges that belong to a cell and come near a box. To it belong its corner a, the edges from
/// there to b and c, and the diagonal; at the far sides of the cloth also what no other cell has.
class CellFeatures {
public:
    CellFeatures(const ClothAt& cloth, int cell, const Aabb& box, Real margin)
        : x_(cloth.x), box_(box), margin_(margin) {
        const Grid& grid = cloth.grid;
        const int a = grid.cell_corner(cell), b = a + 1, c = a + grid.nx, d = c + 1;
        const bool last_column = cell % grid.cell_columns() == grid.cell_columns() - 1;
        const bool last_row = cell / grid.cell_columns() == grid.cell_rows() - 1;
        add(a), add(a, b), add(a, c), add(b, c);
        if (last_column) add(b), add(b, d);
        if (last_row) add(c), add(c, d);
        if (last_column && last_row) add(d);
    }

    [[nodiscard]] auto particles() const { return std::span(particles_).first(particle_count_); }
    [[nodiscard]] auto edges() const { return std::span(edges_).first(edge_count_); }

private:
    void add(int particle) {
        const Vec3 p = position(x_, particle);
        if (Aabb{p, p}.comes_within(box_, margin_)) particles_[particle_count_++] = particle;
    }
    void add(int from, int to) {
        const Vec3 p = position(x_, from), q = position(x_, to);
        const Aabb box{p.cwiseMin(q), p.cwiseMax(q)};
        if (box.comes_within(box_, margin_)) edges_[edge_count_++] = {{from, to}, box};
    }

    const Points& x_;
    const Aabb& box_;
    Real margin_;
    std::array<int, 4> particles_;
    std::array<CellEdge, 5> edges_;
    std::size_t particle_count_ = 0, edge_count_ = 0;
};

/// Whether a particle's closest point of a triangle is to be answered for there, and not by another triangle that has
/// it too, nor, where it is a corner, by that corner's particle.
bool is_answered_here(const Grid& grid, const NearPair& pair) {
    const OnTriangle on = feature_at({pair.weights[1], pair.weights[2], pair.weights[3]});
    if (on.zeros == 0) return true;
    if (on.zeros == 1) return !other_reports_edge(grid, pair.triangle, on.opposite);
    const auto& [cloths, count, particles] = pair.features;
    std::size_t corner = 1;
    while (pair.weights[corner] == 0) ++corner;
    const bool lower = cloths[0] != cloths[1] ? cloths[0] < cloths[1] : particles[0] < particles[corner];
    return lower && owner_of(grid, particles[corner]) == pair.triangle;
}

/// From the second feature's closest point to the first's.
Vec3 locate_on_triangle(const ClothAt& first, const ClothAt& second, NearPair& pair) {
    const auto& [particle, a, b, c] = pair.features.particles;
    const Vec3 p = position(first.x, particle);
    const ClosestPoint closest = closest_point(second.x, {a, b, c}, p);
    const auto [u, v, w] = closest.barycentric;
    pair.weights = {1, u, v, w};
    pair.stands_alone = is_answered_here(second.grid, pair);
    return p - closest.point;
}

/// An end is a particle, and near a triangle.
Vec3 locate_on_edges(const ClothAt& first, const ClothAt& second, NearPair& pair) {
    const auto& [a, b, c, d] = pair.features.particles;
    const auto [s, t, offset] =
        closest_of_segments(position(first.x, a), position(first.x, b), position(second.x, c), position(second.x, d));
    pair.weights = {1 - s, s, 1 - t, t};
    pair.stands_alone = s > 0 && s < 1 && t > 0 && t < 1;
    return offset;
}

/// Tests features of cells exactly.
struct FeatureTest {
    Real margin;
    std::vector<NearPair>& pairs;

    void keep(const ClothAt& first, const ClothAt& second, NearPair pair) const {
        locate(first, second, pair);
        if (pair.distance < margin) pairs.push_back(pair);
    }

    void particle_and_cell(const ClothAt& first, int particle, const ClothAt& second, int cell) const {
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            const std::array<int, 3> corners = second.grid.triangle_corners(triangle);
            if (first.number == second.number && std::ranges::count(corners, particle) > 0) continue;
            keep(first, second,
                 {{{first.number, second.number}, 1, {particle, corners[0], corners[1], corners[2]}}, triangle});
        }
    }

    void edges(const ClothAt& first, const std::array<int, 2>& e, const ClothAt& second,
               const std::array<int, 2>& f) const {
        const bool touch = e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1];
        if (first.number == second.number && touch) return;
        keep(first, second, {{{first.number, second.number}, 2, {e[0], e[1], f[0], f[1]}}});
    }

    void cells(const BoxedCloth& first, int one, const BoxedCloth& second, int two) const {
        const bool same = first.cloth.number == second.cloth.number && one == two;
        const CellFeatures of_one(first.cloth, one, second.boxes[two], margin);
        const CellFeatures of_two(second.cloth, two, first.boxes[one], margin);
        for (const int particle : of_one.particles()) particle_and_cell(first.cloth, particle, second.cloth, two);
        for (const int particle : of_two.particles()) {
            if (!same) particle_and_cell(second.cloth, particle, first.cloth, one);
        }
        for (std::size_t i = 0; i < of_one.edges().size(); ++i) {
            for (std::size_t j = same ? i + 1 : 0; j < of_two.edges().size(); ++j) {
                const CellEdge &e = of_one.edges()[i], &f = of_two.edges()[j];
                if (e.box.comes_within(f.box, margin)) edges(first.cloth, e.ends, second.cloth, f.ends);
            }
        }
    }
};

/// Calls visit(cell) for each cell of a range.
template <class Visit>
void for_each_cell_of(const Grid& grid, const CellRange& cells, Visit visit) {
    for (int j = cells.j0; j < cells.j1; ++j) {
        for (int i = cells.i0; i < cells.i1; ++i) visit(j * grid.cell_columns() + i);
    }
}

}  // namespace

/// Where both points are one, any direction serves.
void locate(const ClothAt& first, const ClothAt& second, NearPair& pair) {
    const Vec3 offset =
        pair.triangle < 0 ? locate_on_edges(first, second, pair) : locate_on_triangle(first, second, pair);
    pair.distance = offset.norm();
    pair.normal = pair.distance > 0 ? Vec3(offset / pair.distance) : Vec3(0, 1, 0);
}

void CellBoxes::build(const Grid& grid, const Points& x) {
    boxes_.resize(static_cast<std::size_t>(grid.cells()));
    for (int cell = 0; cell < grid.cells(); ++cell) {
        const int a = grid.cell_corner(cell);
        Aabb box{position(x, a), position(x, a)};
        for (const int p : {a + 1, a + grid.nx, a + grid.nx + 1}) box.include(position(x, p));
        boxes_[static_cast<std::size_t>(cell)] = box;
    }
}

Aabb CellBoxes::of(const Grid& grid, const CellRange& cells) const {
    Aabb all = (*this)[cells.j0 * grid.cell_columns() + cells.i0];
    for_each_cell_of(grid, cells, [&](int cell) { all.include((*this)[cell]); });
    return all;
}

std::int64_t find_near_pairs(const BoxedCloth& first, const BoxedCloth& second, Real margin,
                             const std::vector<LeafPair>& leaves, std::vector<NearPair>& pairs) {
    const FeatureTest test{margin, pairs};
    std::int64_t tested = 0;
    for (const auto& [cells, others] : leaves) {
        const bool same = first.cloth.number == second.cloth.number && cells == others;
        const Aabb around = second.boxes.of(second.cloth.grid, others);
        for_each_cell_of(first.cloth.grid, cells, [&](int one) {
            if (!first.boxes[one].comes_within(around, margin)) return;
            for_each_cell_of(second.cloth.grid, others, [&](int two) {
                if ((same && two < one) || !first.boxes[one].comes_within(second.boxes[two], margin)) return;
                ++tested;
                // Of one cloth, in the order of the cells whatever the order of the leaves
                const bool turned = first.cloth.number == second.cloth.number && two < one;
                turned ? test.cells(second, two, first, one) : test.cells(first, one, second, two);
            });
        });
    }
    return tested;
}

}  // namespace drape
