#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "closed_mesh.h"

namespace drape {
namespace {

/// Less than this of the square of its longest side, and a triangle has no area to speak of.
constexpr Real min_area = Real(1e-6);

/// The corners, rotated so that the side from the last to the first is the longest.
Corners longest_last(const TriangleMesh& mesh, Corners t) {
    const auto length = [&](std::size_t from) {
        return (point(mesh, t[from]) - point(mesh, t[(from + 1) % 3])).squaredNorm();
    };
    const std::array<Real, 3> lengths{length(0), length(1), length(2)};
    const auto longest = std::ranges::max_element(lengths) - lengths.begin();
    std::rotate(t.begin(), t.begin() + (longest + 1) % 3, t.end());
    return t;
}

bool is_needle(const TriangleMesh& mesh, const Corners& t) {
    const auto [a, b, c] = longest_last(mesh, t);
    const Vec3 along = point(mesh, c) - point(mesh, a);
    return !(along.cross(point(mesh, b) - point(mesh, a)).norm() > min_area * along.squaredNorm());
}

}  // namespace

/// Points within reach of each other lie in one cell of at least one of eight grids, whose cells are twice as wide and
/// which differ by half a cell along one or more axes.
TriangleMesh weld(const std::vector<MeshTriangle>& triangles, Real reach) {
    using Cell = std::array<std::int64_t, 3>;
    const auto corner = [&](std::size_t p) -> const Vec3& { return triangles[p / 3][p % 3]; };
    DisjointSets places(3 * triangles.size());
    std::vector<std::pair<Cell, int>> cells(3 * triangles.size());
    for (unsigned grid = 0; grid < 8; ++grid) {
        for (std::size_t p = 0; p < cells.size(); ++p) {
            cells[p].second = static_cast<int>(p);
            for (unsigned axis = 0; axis < 3; ++axis) {
                const Real shift = (grid >> axis & 1U) != 0 ? Real(0.5) : Real(0);
                cells[p].first[axis] = static_cast<std::int64_t>(std::floor(corner(p)[axis] / (2 * reach) + shift));
            }
        }
        std::ranges::sort(cells);
        for (std::size_t k = 1; k < cells.size(); ++k) {
            if (cells[k].first == cells[k - 1].first) places.unite(cells[k].second, cells[k - 1].second);
        }
    }
    TriangleMesh mesh;
    std::vector<int> numbers(cells.size());
    for (std::size_t p = 0; p < cells.size(); ++p) {
        const auto first = static_cast<std::size_t>(places.first_of(static_cast<int>(p)));
        if (first == p) {
            numbers[p] = static_cast<int>(mesh.points.size());
            mesh.points.push_back(corner(p));
        }
        numbers[p] = numbers[first];
        if (p % 3 < 2) continue;
        const Corners t{numbers[p - 2], numbers[p - 1], numbers[p]};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
    }
    return mesh;
}

bool remove_needles(TriangleMesh& mesh) {
    constexpr int max_cuts = 1000;
    std::vector<Corners>& triangles = mesh.triangles;
    int cuts = 0;
    for (auto needle = triangles.begin(); needle != triangles.end();) {
        if (!is_needle(mesh, *needle)) {
            ++needle;
            continue;
        }
        const auto [a, b, c] = longest_last(mesh, *needle);
        const auto side_in = [a = a, c = c](const Corners& t) {
            const auto from = std::ranges::find(t, a);
            return from != t.end() && t[static_cast<std::size_t>(from - t.begin() + 1) % 3] == c;
        };
        const auto across = std::ranges::find_if(triangles, side_in);
        if (across == triangles.end() || ++cuts > max_cuts) return false;
        const int d = *std::ranges::find_if(*across, [a = a, c = c](int p) { return p != a && p != c; });
        if (d == b) return false;
        *needle = {a, b, d};
        *across = {b, c, d};
        needle = std::min(needle, across);
    }
    return true;
}

}  // namespace drape
