#include "drape/bounds/fold_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace drape {
namespace {

/// Of what a bound loses by rounding, far more than it can.
constexpr Real fold_rounding = 256 * std::numeric_limits<Real>::epsilon();

/// The two directions at right angles that are nearest to the columns of F: Q = F R^-1 with R = sqrt(F^T F), the
/// rotation of the polar decomposition. Zero if F has no such.
Eigen::Matrix<Real, 3, 2> nearest_directions(const Vec3& along, const Vec3& across) {
    Eigen::Matrix<Real, 3, 2> f;
    f << along, across;
    Eigen::Matrix<Real, 2, 2> square = f.transpose() * f;
    const Real root = std::sqrt(std::max(square.determinant(), Real(0)));
    const Real scale = std::sqrt(square.trace() + 2 * root);
    if (!(root > 0)) return Eigen::Matrix<Real, 3, 2>::Zero();
    square.diagonal().array() += root;
    return f * (square / scale).inverse();
}

/// What a direction's product with anything in a box is at least, and at most.
Real least_along(const Vec3& direction, const Aabb& box) {
    return direction.dot(box.low + box.high) / 2 - direction.cwiseAbs().dot(box.high - box.low) / 2;
}
Real most_along(const Vec3& direction, const Aabb& box) { return -least_along(-direction, box); }

/// Whether two rectangles of cells together are one.
bool make_rectangle(const CellRange& first, const CellRange& second) {
    const bool same_rows = first.j0 == second.j0 && first.j1 == second.j1;
    const bool same_columns = first.i0 == second.i0 && first.i1 == second.i1;
    return (same_rows && (first.i1 == second.i0 || second.i1 == first.i0)) ||
           (same_columns && (first.j1 == second.j0 || second.j1 == first.j0));
}

std::array<int, 3> corner_of(const QuadtreeNode& node) { return {node.level, node.i0, node.j0}; }

}  // namespace

FoldTest::FoldTest(const Grid& grid, Real hx, Real hy, int leaf_cells)
    : grid_(grid), hx_(hx), hy_(hy), nodes_(make_quadtree_nodes(grid, leaf_cells)), derivatives_(nodes_.size()) {
    by_corner_.resize(nodes_.size());
    std::iota(by_corner_.begin(), by_corner_.end(), 0);
    std::ranges::sort(by_corner_, {}, [&](int n) { return corner_of(nodes_[static_cast<std::size_t>(n)]); });
}

void FoldTest::build(const Points& x, std::span<const Real> reaches) {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        const QuadtreeNode& node = nodes_[n];
        if (node.children == 0) {
            derivatives_[n] = of_leaf(node, x, reaches);
            continue;
        }
        const auto first = static_cast<std::size_t>(node.first_child);
        Derivatives all = derivatives_[first];
        for (std::size_t child = 1; child < static_cast<std::size_t>(node.children); ++child) {
            all.include(derivatives_[first + child]);
            all.reach = std::max(all.reach, derivatives_[first + child].reach);
        }
        derivatives_[n] = all;
    }
}

FoldTest::Derivatives FoldTest::of_leaf(const QuadtreeNode& leaf, const Points& x,
                                        std::span<const Real> reaches) const {
    const auto edge = [&](int from, int to) -> Vec3 { return (x.row(to) - x.row(from)).transpose(); };
    const int corner = grid_.particle(leaf.i0, leaf.j0);
    const Vec3 along = edge(corner, corner + 1), across = edge(corner, corner + grid_.nx);
    const Real at_first = reaches.empty() ? std::numeric_limits<Real>::infinity() : 0;
    Derivatives all{{along, along}, {across, across}, at_first};
    for (int j = leaf.j0; j <= leaf.j1; ++j) {
        for (int i = leaf.i0; i <= leaf.i1; ++i) {
            const int p = grid_.particle(i, j);
            if (!reaches.empty()) all.reach = std::max(all.reach, reaches[static_cast<std::size_t>(p)]);
            if (i < leaf.i1) all.along.include(edge(p, p + 1));
            if (j < leaf.j1) all.across.include(edge(p, p + grid_.nx));
        }
    }
    for (Vec3* end : {&all.along.low, &all.along.high}) *end /= hx_;
    for (Vec3* end : {&all.across.low, &all.across.high}) *end /= hy_;
    return all;
}

/// The least eigenvalue of the symmetric part of Q^T F is c.
bool FoldTest::bounds(const Derivatives& derivatives, Real distance) const {
    const auto& [along, across, reach] = derivatives;
    const Eigen::Matrix<Real, 3, 2> q =
        nearest_directions((along.low + along.high) / 2, (across.low + across.high) / 2);
    const Vec3 u = q.col(0), v = q.col(1);
    const Real m11 = least_along(u, along), m22 = least_along(v, across);
    const Real most = most_along(v, along) + most_along(u, across);
    const Real lowest = least_along(v, along) + least_along(u, across);
    const Real m12 = std::max(std::abs(most), std::abs(lowest)) / 2, half = (m11 - m22) / 2;
    const Real c = (m11 + m22) / 2 - std::sqrt(half * half + m12 * m12);
    const Real least = c - fold_rounding;
    return least * apart_at_rest(hx_, hy_) > std::min(distance, 2 * reach);
}

bool FoldTest::node_is_separated(int node, Real distance) const {
    return bounds(derivatives_[static_cast<std::size_t>(node)], distance);
}

/// The other two of four nodes of a level that meet at a corner and are a rectangle together; -1: there are none.
std::array<int, 2> FoldTest::at_corner_of(int first, int second) const {
    const auto node = [&](int number) -> const QuadtreeNode& { return nodes_[static_cast<std::size_t>(number)]; };
    const QuadtreeNode &one = node(first), &two = node(second);
    const bool share_corner =
        one.level == two.level && (one.i1 == two.i0 || one.i0 == two.i1) && (one.j1 == two.j0 || one.j0 == two.j1);
    if (!share_corner) return {-1, -1};
    const auto beside_both = [&](int i0, int j0) {
        const std::array<int, 3> corner{one.level, i0, j0};
        const auto found = std::ranges::lower_bound(by_corner_, corner, {}, [&](int n) { return corner_of(node(n)); });
        if (found == by_corner_.end() || corner_of(node(*found)) != corner) return -1;
        return make_rectangle(one, node(*found)) && make_rectangle(two, node(*found)) ? *found : -1;
    };
    const std::array<int, 2> others{beside_both(two.i0, one.j0), beside_both(one.i0, two.j0)};
    return std::min(others[0], others[1]) < 0 ? std::array{-1, -1} : others;
}

bool FoldTest::nodes_are_separated(int first, int second, Real distance) const {
    const auto of = [&](int node) -> const Derivatives& { return derivatives_[static_cast<std::size_t>(node)]; };
    const bool side_by_side =
        make_rectangle(nodes_[static_cast<std::size_t>(first)], nodes_[static_cast<std::size_t>(second)]);
    const std::array<int, 2> others = side_by_side ? std::array{first, second} : at_corner_of(first, second);
    if (others[0] < 0) return false;
    const Derivatives &one = of(first), &two = of(second);
    Derivatives all{one.along, one.across, (one.reach + two.reach) / 2};
    all.include(two);
    for (const int other : others) all.include(of(other));
    return bounds(all, distance);
}

}  // namespace drape
