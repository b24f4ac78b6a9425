#include "closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

using Box = Eigen::AlignedBox<Real, 3>;

constexpr Real reach_of_size = Real(1e-6);  ///< within which places are one, of the mesh's size
constexpr Real min_thickness = Real(1e-9);  ///< volume of a part, of its area to the power 3/2
constexpr std::size_t max_parts = 1000;

/// Three points of a mesh, by index.
using Corners = std::array<int, 3>;

const Vec3& point(const TriangleMesh& mesh, int p) { return mesh.points[static_cast<std::size_t>(p)]; }

/// Sets of numbers that are united step by step.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

    /// The smallest number in the same set.
    int first_of(int number) {
        const auto parent = [&](int of) -> int& { return parents_[static_cast<std::size_t>(of)]; };
        while (parent(number) != number) number = parent(number) = parent(parent(number));
        return number;
    }

    void unite(int one, int other) {
        const auto [low, high] = std::minmax({first_of(one), first_of(other)});
        parents_[static_cast<std::size_t>(high)] = low;
    }

private:
    std::vector<int> parents_;
};

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

/// The triangles with corners in common: those within `reach` of each other, or of others that are, become one [m].
/// Triangles of fewer than three points go.
/// @par Cost O(n log n)
///
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

/// Takes away triangles whose corners are in line: the middle one becomes a corner of the triangle across the longest
/// side, which is cut there.
/// @return false if there are triangles for which that does not help
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

/// A side of a triangle.
struct MeshSide {
    int low, high;  ///< its ends
    int triangle;
    int direction;  ///< 1 from low to high, or -1
};

/// Says of the triangles which connected part they are of, and turns the parts.
class MeshParts {
public:
    /// Two triangles that have a side are of one part. Where parts touch along a side it has four, of which those that
    /// are next to each other in the file belong together.
    MeshParts(TriangleMesh& mesh, Real reach, std::string file) : mesh_(mesh), reach_(reach), file_(std::move(file)) {
        const int triangles = static_cast<int>(mesh.triangles.size());
        for (int t = 0; t < triangles; ++t) {
            const Corners& corners = mesh.triangles[static_cast<std::size_t>(t)];
            for (std::size_t k = 0; k < 3; ++k) {
                const int from = corners[k], to = corners[(k + 1) % 3];
                sides_.push_back({std::min(from, to), std::max(from, to), t, from < to ? 1 : -1});
            }
        }
        const auto ends = [](const MeshSide& side) { return std::pair(side.low, side.high); };
        std::ranges::stable_sort(sides_, {}, ends);
        DisjointSets sets(mesh.triangles.size());
        for (auto first = sides_.begin(); first != sides_.end();) {
            const auto last =
                std::find_if(first, sides_.end(), [&](const auto& side) { return ends(side) != ends(*first); });
            for (; last - first > 1; first += 2) sets.unite(first->triangle, (first + 1)->triangle);
            first = last;
        }
        for (int t = 0; t < triangles; ++t) {
            const int first = sets.first_of(t);
            parts_.push_back(first == t ? count_++ : part(first));
        }
        if (count_ > static_cast<int>(max_parts)) {
            fail(std::to_string(count_) + " separate parts: allowed at most " + std::to_string(max_parts));
        }
    }

    /// @throws InputError unless on each side of a part as many triangles go one way as the other
    void check_closed() const {
        std::map<std::array<int, 3>, int> surplus;
        for (const MeshSide& side : sides_) surplus[{side.low, side.high, part(side.triangle)}] += side.direction;
        for (const auto& [key, count] : surplus) {
            if (count == 0) continue;
            fail("the side from " + point_text(point(mesh_, key[0])) + " to " + point_text(point(mesh_, key[1])) +
                 " is " + (std::abs(count) == 1 ? "of one triangle alone" : "in the same direction twice") +
                 ": allowed only closed surfaces of one orientation");
        }
    }

    /// @throws InputError if an edge of one triangle passes through the inside of another. Goes through the triangles
    /// along the longest axis, with those in sight whose boxes have not ended.
    void check_crossings() const {
        std::vector<Box> boxes;
        Box all;
        for (const Corners& corners : mesh_.triangles) {
            Box& box = boxes.emplace_back();
            for (const int p : corners) box.extend(point(mesh_, p));
            all.extend(box);
        }
        Eigen::Index axis = 0;
        all.sizes().maxCoeff(&axis);
        const auto box = [&](int t) -> const Box& { return boxes[static_cast<std::size_t>(t)]; };
        std::vector<int> order(boxes.size()), in_sight;
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order, {}, [&](int t) { return std::pair(box(t).min()[axis], t); });
        for (const int t : order) {
            std::erase_if(in_sight, [&](int other) { return box(other).max()[axis] < box(t).min()[axis]; });
            for (const int other : in_sight) {
                if (!box(t).intersects(box(other)) || !(passes(t, other) || passes(other, t))) continue;
                fail("the surface crosses itself near " + point_text(box(t).intersection(box(other)).center()) +
                     ": allowed only one that does not");
            }
            in_sight.push_back(t);
        }
    }

    /// Turns what is inside out.
    void orient() {
        turn(inside_out());
        std::vector<TriangleMesh> parts;
        for (int k = 0; count_ > 1 && k < count_; ++k) parts.push_back(only(k));
        std::vector<bool> is_cavity(static_cast<std::size_t>(count_), false);
        for (std::size_t outer = 0; outer < parts.size(); ++outer) {
            const auto shape = make_mesh_shape(parts[outer]);
            for (std::size_t inner = 0; inner < parts.size(); ++inner) {
                if (inner != outer && encloses(*shape, parts[inner])) is_cavity[inner] = !is_cavity[inner];
            }
        }
        turn(is_cavity);
    }

private:
    [[nodiscard]] int part(int triangle) const { return parts_[static_cast<std::size_t>(triangle)]; }

    /// Whether an edge of the triangle, or a line across it, goes through the inside of the other, farther than places
    /// that are one. The lines see what crosses just where two triangles meet.
    bool passes(int triangle, int other) const {
        constexpr Real off_centre = Real(0.382);
        const auto corner = [&](int t, std::size_t k) -> const Vec3& {
            return point(mesh_, mesh_.triangles[static_cast<std::size_t>(t)][k % 3]);
        };
        const Vec3& a = corner(other, 0);
        const Vec3 normal = (corner(other, 1) - a).cross(corner(other, 2) - a).normalized();
        const auto is_inside = [&](const Vec3& p) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 along = corner(other, k + 1) - corner(other, k);
                if (!(normal.dot(along.cross(p - corner(other, k))) > reach_ * along.norm())) return false;
            }
            return true;
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &p = corner(triangle, k), &next = corner(triangle, k + 1);
            for (const Vec3& q : {next, Vec3(next + off_centre * (corner(triangle, k + 2) - next))}) {
                const Real from = (p - a).dot(normal), to = (q - a).dot(normal);
                if (std::min(from, to) < -reach_ && std::max(from, to) > reach_ &&
                    is_inside(p + from / (from - to) * (q - p)))
                    return true;
            }
        }
        return false;
    }

    /// The volume of a part is that of the tetrahedra from a point to its triangles.
    std::vector<bool> inside_out() const {
        std::vector<Real> volumes(static_cast<std::size_t>(count_), 0), areas = volumes;
        for (std::size_t t = 0; t < parts_.size(); ++t) {
            const Vec3& origin = mesh_.points.front();
            const auto from_origin = [&](std::size_t k) { return Vec3(point(mesh_, mesh_.triangles[t][k]) - origin); };
            const Vec3 a = from_origin(0), b = from_origin(1), c = from_origin(2);
            volumes[static_cast<std::size_t>(parts_[t])] += a.dot(b.cross(c)) / 6;
            areas[static_cast<std::size_t>(parts_[t])] += (b - a).cross(c - a).norm() / 2;
        }
        std::vector<bool> negative;
        for (std::size_t k = 0; k < volumes.size(); ++k) {
            negative.push_back(volumes[k] < 0);
            if (std::abs(volumes[k]) > min_thickness * areas[k] * std::sqrt(areas[k])) continue;
            fail("part " + std::to_string(k + 1) + " of " + std::to_string(volumes.size()) + " near " +
                 point_text(only(static_cast<int>(k)).points.front()) +
                 " has no volume: allowed only parts that have one");
        }
        return negative;
    }

    TriangleMesh only(int wanted) const {
        TriangleMesh mesh;
        std::map<int, int> numbers;
        for (std::size_t t = 0; t < parts_.size(); ++t) {
            if (parts_[t] != wanted) continue;
            for (int& corner : mesh.triangles.emplace_back(mesh_.triangles[t])) {
                const auto [entry, is_new] = numbers.try_emplace(corner, static_cast<int>(mesh.points.size()));
                if (is_new) mesh.points.push_back(point(mesh_, corner));
                corner = entry->second;
            }
        }
        return mesh;
    }

    /// Surfaces do not cross, so one point of the other decides; one where both touch decides nothing.
    bool encloses(const SolidShape& shape, const TriangleMesh& other) const {
        const auto [low, high] = shape.extent();
        for (const Vec3& p : other.points) {
            if (!((p - low).minCoeff() > 0 && (high - p).minCoeff() > 0)) return false;
            const Real distance = shape.measure(p).distance;
            if (std::abs(distance) > reach_) return distance < 0;
        }
        return false;
    }

    void turn(const std::vector<bool>& turned) {
        for (std::size_t t = 0; t < parts_.size(); ++t) {
            if (turned[static_cast<std::size_t>(parts_[t])]) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
        }
    }

    [[noreturn]] void fail(const std::string& message) const { throw InputError(file_ + ": " + message); }

    TriangleMesh& mesh_;
    Real reach_;
    std::string file_;
    std::vector<MeshSide> sides_;
    std::vector<int> parts_;  ///< of the triangles
    int count_ = 0;
};

}  // namespace

std::string point_text(const Vec3& p) {
    std::string text = "(";
    for (int axis = 0; axis < 3; ++axis) {
        text += (axis == 0 ? "" : ", ") + real_text(static_cast<double>(p[axis]), 6);
    }
    return text + ")";
}

TriangleMesh closed_mesh(const std::vector<MeshTriangle>& triangles, const std::string& file) {
    Box all;
    for (const MeshTriangle& triangle : triangles) {
        for (const Vec3& corner : triangle) all.extend(corner);
    }
    const Real reach = triangles.empty() ? Real(1) : std::max(reach_of_size * all.diagonal().norm(), Real(1e-9));
    TriangleMesh mesh = weld(triangles, reach);
    if (mesh.triangles.size() < 4) {
        throw InputError(file + ": " + std::to_string(mesh.triangles.size()) +
                         " faces: allowed a closed mesh of at least 4");
    }
    if (!remove_needles(mesh)) throw InputError(file + ": triangles without area: allowed at most single ones");
    MeshParts parts(mesh, reach, file);
    parts.check_closed();
    parts.check_crossings();
    parts.orient();
    return mesh;
}

}  // namespace drape
