#include "mesh_builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr std::size_t most_mesh_points = 100'000, most_mesh_triangles = 200'000;
constexpr double farthest_point = 1e3;  // m

/// Less than this of the square of its longest side, and a triangle has no area to speak of.
constexpr Real least_area = Real(1e-6);

std::string text_of_point(const Vec3& p) {
    std::string text = "(";
    for (int axis = 0; axis < 3; ++axis) {
        text += (axis == 0 ? "" : ", ") + real_text(static_cast<double>(p[axis]), 6);
    }
    return text + ")";
}

}  // namespace

std::string_view next_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

Vec3 read_point(const MeshBuilder& mesh, std::string_view what, std::string_view rest) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = next_word(rest);
        point[axis] = mesh.coordinate(what, parse_real(word).value_or(none), word);
    }
    return point;
}

Real MeshBuilder::coordinate(std::string_view what, double value, std::string_view text) const {
    if (!(value >= -farthest_point && value <= farthest_point)) {
        fail(std::string(what) + ": '" + shortened(text) + "': allowed three numbers, each -1000 <= x <= 1000 m");
    }
    return static_cast<Real>(value);
}

void MeshBuilder::add_point(const Vec3& point) {
    if (mesh_.points.size() == most_mesh_points) {
        fail("too many points: allowed at most " + std::to_string(most_mesh_points));
    }
    mesh_.points.push_back(point);
}

void MeshBuilder::add_triangle(std::string_view what, const std::array<int, 3>& corners) {
    if (mesh_.triangles.size() == most_mesh_triangles) {
        fail("too many triangles: allowed at most " + std::to_string(most_mesh_triangles));
    }
    const auto point = [&](std::size_t k) { return mesh_.points[static_cast<std::size_t>(corners[k])]; };
    const Vec3 first = point(1) - point(0), second = point(2) - point(0), third = point(2) - point(1);
    const Real longest = std::max({first.squaredNorm(), second.squaredNorm(), third.squaredNorm()});
    if (!(first.cross(second).norm() > least_area * longest)) {
        fail(std::string(what) + ": a triangle without area: allowed at least 1e-06 of its longest side's square");
    }
    mesh_.triangles.push_back(corners);
    for (std::size_t k = 0; k < 3; ++k) edges_.push_back({corners[k], corners[(k + 1) % 3], place_});
}

TriangleMesh MeshBuilder::finish(std::string_view what) {
    if (mesh_.triangles.empty()) throw InputError(file_ + ": 0 faces: allowed a closed mesh of at least 4");
    check_closed(what);
    check_outward();
    return std::move(mesh_);
}

/// Every side of a triangle is that of just one other triangle, which has it the other way round.
void MeshBuilder::check_closed(std::string_view what) {
    const auto ends = [](const DirectedEdge& edge) { return std::pair(edge.from, edge.to); };
    std::ranges::sort(edges_, {}, ends);
    const auto twice = std::ranges::adjacent_find(edges_, {}, ends);
    if (twice != edges_.end()) {
        fail_at(what, *(twice + 1), "in the same direction twice: allowed only a surface of one orientation");
    }
    for (const DirectedEdge& edge : edges_) {
        const bool has_other = std::ranges::binary_search(edges_, std::pair(edge.to, edge.from), {}, ends);
        if (!has_other) fail_at(what, edge, "of one triangle alone: allowed only a closed surface of one orientation");
    }
}

/// The volume is that of the tetrahedra from the first point to all triangles.
void MeshBuilder::check_outward() const {
    Real volume = 0;
    const Vec3& origin = mesh_.points.front();
    for (const auto& [a, b, c] : mesh_.triangles) {
        const auto from_origin = [&](int p) { return Vec3(mesh_.points[static_cast<std::size_t>(p)] - origin); };
        volume += from_origin(a).dot(from_origin(b).cross(from_origin(c))) / 6;
    }
    if (volume > 0) return;
    throw InputError(file_ + ": a volume of " + real_text(static_cast<double>(volume), 3) +
                     " m^3: allowed only triangles that are counter-clockwise seen from outside");
}

void MeshBuilder::fail_at(std::string_view what, const DirectedEdge& edge, const std::string& why) {
    place_ = edge.place;
    const auto point = [&](int p) {
        return std::to_string(p + 1) + " " + text_of_point(mesh_.points[static_cast<std::size_t>(p)]);
    };
    fail(std::string(what) + ": the side from point " + point(edge.from) + " to " + point(edge.to) + " is " + why);
}

void MeshBuilder::fail(const std::string& message) const {
    throw InputError(file_ + ":" + (unit_.empty() ? "" : " " + unit_) + std::to_string(place_) + ": " + message);
}

void MeshBuilder::fail_line_length() const {
    fail("a line of more than " + std::to_string(longest_mesh_line) + " bytes: allowed at most as many");
}

}  // namespace drape
