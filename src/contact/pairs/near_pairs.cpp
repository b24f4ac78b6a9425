#include "drape/contact/near_pairs.h"

#include <algorithm>
#include <limits>
#include <span>

#include "cell_pairs.h"
#include "contact/grid_features.h"
#include "drape/contact/closest_point.h"
#include "pair_tests.h"

namespace drape {
namespace {

/// An edge and its box.
struct CellEdge {
    std::array<int, 2> ends;
    Aabb box;
};

/// Of the feature of some particles.
template <class... Particles>
Real reach_of(std::span<const Real> reaches, Particles... particles) {
    return std::max({reaches[static_cast<std::size_t>(particles)]...});
}

/// The particles and the edges that belong to a cell and reach a box.
class CellFeatures {
public:
    CellFeatures(const BoxedCloth& cloth, int cell, const Aabb& box)
        : x_(cloth.cloth.x), reaches_(cloth.reaches), box_(box) {
        const Grid& grid = cloth.cloth.grid;
        for_each_particle_of(grid, cell % grid.cell_columns(), cell / grid.cell_columns(),
                             [&](int particle) { add(particle); });
        for_each_edge_of(grid, cell, [&](int from, int to) { add(from, to); });
    }

    [[nodiscard]] auto particles() const { return std::span(particles_).first(particle_count_); }
    [[nodiscard]] auto edges() const { return std::span(edges_).first(edge_count_); }

private:
    void add(int particle) {
        const Vec3 p = position(x_, particle);
        if (Aabb{p, p}.comes_within(box_, reach_of(reaches_, particle))) {
            particles_[particle_count_++] = particle;
        }
    }
    void add(int from, int to) {
        const Vec3 p = position(x_, from), q = position(x_, to);
        const Aabb box{p.cwiseMin(q), p.cwiseMax(q)};
        if (box.comes_within(box_, reach_of(reaches_, from, to))) edges_[edge_count_++] = {{from, to}, box};
    }

    const Points& x_;
    std::span<const Real> reaches_;
    const Aabb& box_;
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
    pair.is_representative = is_answered_here(second.grid, pair);
    return p - closest.point;
}

/// An end is a particle, and near a triangle.
Vec3 locate_on_edges(const ClothAt& first, const ClothAt& second, NearPair& pair) {
    const auto& [a, b, c, d] = pair.features.particles;
    const auto [s, t, offset] =
        closest_of_segments(position(first.x, a), position(first.x, b), position(second.x, c), position(second.x, d));
    pair.weights = {1 - s, s, 1 - t, t};
    pair.is_representative = s > 0 && s < 1 && t > 0 && t < 1;
    return offset;
}

/// Tests features of cells exactly.
struct FeatureTest {
    std::vector<NearPair>& pairs;

    /// @param reach of both features together [m]
    void keep(const BoxedCloth& first, const BoxedCloth& second, NearPair pair, Real reach) const {
        const auto at = [&](std::size_t k) {
            return position(pair.features.feature_of(k) == 0 ? first.cloth.x : second.cloth.x,
                            pair.features.particles[k]);
        };
        // Most are, and this is cheaper than where their closest points are
        const bool apart = pair.triangle < 0 ? segments_are_apart(at(0), at(1), at(2), at(3), with_rounding(reach))
                                             : triangle_is_apart(at(0), at(1), at(2), at(3), with_rounding(reach));
        if (apart) return;
        locate(first.cloth, second.cloth, pair);
        if (!(pair.distance < reach)) return;
        pairs.push_back(pair);
    }

    void particle_and_cell(const BoxedCloth& first, int particle, const BoxedCloth& second, int cell) const {
        const std::array cloths{first.cloth.number, second.cloth.number};
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            const std::array<int, 3> corners = second.cloth.grid.triangle_corners(triangle);
            if (cloths[0] == cloths[1] && std::ranges::count(corners, particle) > 0) continue;
            const Real reach =
                reach_of(first.reaches, particle) + reach_of(second.reaches, corners[0], corners[1], corners[2]);
            keep(first, second, {{cloths, 1, {particle, corners[0], corners[1], corners[2]}}, triangle}, reach);
        }
    }

    void edges(const BoxedCloth& first, const CellEdge& one, const BoxedCloth& second, const CellEdge& two) const {
        const auto &e = one.ends, &f = two.ends;
        const std::array cloths{first.cloth.number, second.cloth.number};
        const bool touch = e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1];
        if (cloths[0] == cloths[1] && touch) return;
        const Real reach = reach_of(first.reaches, e[0], e[1]) + reach_of(second.reaches, f[0], f[1]);
        if (!one.box.comes_within(two.box, reach)) return;
        keep(first, second, {{cloths, 2, {e[0], e[1], f[0], f[1]}}}, reach);
    }

    void cells(const BoxedCloth& first, int one, const BoxedCloth& second, int two) const {
        const bool same = first.cloth.number == second.cloth.number && one == two;
        const CellFeatures of_one(first, one, second.boxes.of(two));
        const CellFeatures of_two(second, two, first.boxes.of(one));
        for (const int particle : of_one.particles()) particle_and_cell(first, particle, second, two);
        for (const int particle : of_two.particles()) {
            if (!same) particle_and_cell(second, particle, first, one);
        }
        for (std::size_t i = 0; i < of_one.edges().size(); ++i) {
            for (std::size_t j = same ? i + 1 : 0; j < of_two.edges().size(); ++j) {
                edges(first, of_one.edges()[i], second, of_two.edges()[j]);
            }
        }
    }
};

/// No coordinate of a scene is larger [m].
constexpr Real largest_coordinate = Real(1e4);

/// Of what is computed from coordinates up to a size [m].
Real rounding_of(Real size) { return 64 * std::numeric_limits<Real>::epsilon() * size; }

/// Whether the distance of two features is no more than rounding, and the direction between them says nothing.
bool is_rounding(const ClothAt& first, const ClothAt& second, const NearPair& pair) {
    if (pair.distance > rounding_of(largest_coordinate)) return false;
    Real size = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const ClothAt& cloth = pair.features.feature_of(k) == 0 ? first : second;
        size = std::max(size, position(cloth.x, pair.features.particles[k]).cwiseAbs().maxCoeff());
    }
    return pair.distance <= rounding_of(size);
}

}  // namespace

void locate(const ClothAt& first, const ClothAt& second, NearPair& pair) {
    const Vec3 offset =
        pair.triangle < 0 ? locate_on_edges(first, second, pair) : locate_on_triangle(first, second, pair);
    pair.distance = offset.norm();
    if (is_rounding(first, second, pair)) pair.distance = 0;
    pair.normal = pair.distance > 0 ? Vec3(offset / pair.distance) : Vec3::Zero();
}

ContactRow row_of(const NearPair& pair, Real thickness) {
    ContactRow row;
    row.kind = RowKind::Pair;
    row.count = 4;
    row.first_count = pair.features.first_count;
    row.triangle = pair.triangle;
    row.distance = thickness;
    for (std::size_t k = 0; k < 4; ++k) {
        row.particles[k] = {pair.features.cloth_of(k), pair.features.particles[k], 0};
    }
    set_plane(pair, row);
    return row;
}

void CellBoxes::build(const Grid& grid, const Points& x, std::span<const Real> reaches) {
    boxes_.resize(static_cast<std::size_t>(grid.cells()));
    for (int cell = 0; cell < grid.cells(); ++cell) {
        const int a = grid.cell_corner(cell), b = a + 1, c = a + grid.nx, d = c + 1;
        Aabb box{position(x, a), position(x, a)};
        for (const int p : {b, c, d}) box.include(position(x, p));
        const Real reach = reaches.empty() ? Real(0) : reach_of(reaches, a, b, c, d);
        box.low.array() -= reach;
        box.high.array() += reach;
        boxes_[static_cast<std::size_t>(cell)] = box;
    }
}

Aabb CellBoxes::of(const Grid& grid, const CellRange& cells) const {
    Aabb all = of(cells.j0 * grid.cell_columns() + cells.i0);
    for_each_cell_of(cells, [&](int i, int j) { all.include(of(j * grid.cell_columns() + i)); });
    return all;
}

void find_near_pairs(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves,
                     std::vector<NearPair>& pairs) {
    for_each_pair_of_cells(first, second, leaves, [&](int one, int two) {
        const FeatureTest test{pairs};
        // Of one cloth, in the order of the cells whatever the order of the leaves
        const bool turned = first.cloth.number == second.cloth.number && two < one;
        turned ? test.cells(second, two, first, one) : test.cells(first, one, second, two);
    });
}

}  // namespace drape
