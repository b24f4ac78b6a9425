#include "mesh_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string_view>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"

// The reader is our own: tinyobjloader 2.0 takes a word that is no number for zero, names no line, and converts
// exponents by a function of the C library, whose last bit differs from processor to processor.

namespace drape {
namespace {

constexpr std::size_t largest_mesh_file = 16 * 1024 * 1024, longest_mesh_line = 4 * 1024;
constexpr std::size_t most_mesh_points = 100'000, most_mesh_triangles = 200'000;
constexpr double farthest_point = 1e3;  // m

/// Less than this of the square of its longest side, and a triangle has no area to speak of.
constexpr Real least_area = Real(1e-6);

/// The next word of a line, which is taken off it.
std::string_view next_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

/// A triangle's side from corner to corner, and where it was read.
struct DirectedEdge {
    int from, to, line;
};

class MeshReader {
public:
    MeshReader(std::istream& in, std::string file) : in_(in), file_(std::move(file)) {}

    TriangleMesh read() {
        std::string line;
        for (;;) {
            ++line_;
            const LineEnd end = read_line(in_, line, longest_mesh_line);
            if (end == LineEnd::None) break;
            if (end == LineEnd::TooLong) {
                fail("a line of more than " + std::to_string(longest_mesh_line) + " bytes: allowed at most as many");
            }
            read_element(line);
        }
        if (mesh_.triangles.empty()) throw InputError(file_ + ": 0 faces: allowed a closed mesh of at least 4");
        check_closed();
        check_outward();
        return std::move(mesh_);
    }

private:
    void read_element(std::string_view rest) {
        const std::string_view kind = next_word(rest);
        if (kind == "v") read_point(rest);
        if (kind == "f") read_face(rest);
    }

    void read_point(std::string_view rest) {
        if (mesh_.points.size() == most_mesh_points) {
            fail("too many points: allowed at most " + std::to_string(most_mesh_points));
        }
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = next_word(rest);
            const auto value = parse_real(word);
            if (!value || !(*value >= -farthest_point && *value <= farthest_point)) {
                fail("v: '" + shortened(word) + "': allowed three numbers, each -1000 <= x <= 1000 m");
            }
            point[axis] = static_cast<Real>(*value);
        }
        mesh_.points.push_back(point);
    }

    /// The number of a corner, counted from 1, or back from the last point, -1.
    int corner_of(std::string_view word) {
        const auto count = static_cast<long long>(mesh_.points.size());
        const auto number = parse_integer(word.substr(0, word.find('/')));
        const bool known = number && ((*number >= 1 && *number <= count) || (*number <= -1 && *number >= -count));
        if (!known) {
            fail("f: '" + shortened(word) + "': allowed points from 1 to " + std::to_string(count) +
                 ", which were read before");
        }
        return static_cast<int>(*number > 0 ? *number - 1 : count + *number);
    }

    void read_face(std::string_view rest) {
        std::vector<int> corners;
        for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
            corners.push_back(corner_of(word));
        }
        if (corners.size() < 3) {
            fail("f: " + std::to_string(corners.size()) + " corners: allowed at least 3");
        }
        for (std::size_t k = 2; k < corners.size(); ++k) add_triangle({corners[0], corners[k - 1], corners[k]});
    }

    void add_triangle(const std::array<int, 3>& corners) {
        if (mesh_.triangles.size() == most_mesh_triangles) {
            fail("too many triangles: allowed at most " + std::to_string(most_mesh_triangles));
        }
        const auto point = [&](std::size_t k) { return mesh_.points[static_cast<std::size_t>(corners[k])]; };
        const Vec3 first = point(1) - point(0), second = point(2) - point(0), third = point(2) - point(1);
        const Real longest = std::max({first.squaredNorm(), second.squaredNorm(), third.squaredNorm()});
        if (!(first.cross(second).norm() > least_area * longest)) {
            fail("f: a triangle without area: allowed at least 1e-06 of its longest side's square");
        }
        mesh_.triangles.push_back(corners);
        for (std::size_t k = 0; k < 3; ++k) edges_.push_back({corners[k], corners[(k + 1) % 3], line_});
    }

    /// Every side of a triangle is that of just one other triangle, which has it the other way round.
    void check_closed() {
        const auto ends = [](const DirectedEdge& edge) { return std::pair(edge.from, edge.to); };
        std::ranges::sort(edges_, {}, ends);
        const auto twice = std::ranges::adjacent_find(edges_, {}, ends);
        if (twice != edges_.end()) {
            fail_at(*(twice + 1), "in the same direction twice: allowed only a surface of one orientation");
        }
        for (const DirectedEdge& edge : edges_) {
            const bool has_other = std::ranges::binary_search(edges_, std::pair(edge.to, edge.from), {}, ends);
            if (!has_other) fail_at(edge, "of one triangle alone: allowed only a closed surface of one orientation");
        }
    }

    /// The volume is that of the tetrahedra from the first point to all triangles.
    void check_outward() const {
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

    [[noreturn]] void fail_at(const DirectedEdge& edge, const std::string& what) {
        line_ = edge.line;
        fail("f: the side from point " + std::to_string(edge.from + 1) + " to " + std::to_string(edge.to + 1) + " is " +
             what);
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(file_ + ":" + std::to_string(line_) + ": " + message);
    }

    std::istream& in_;
    std::string file_;
    TriangleMesh mesh_;
    std::vector<DirectedEdge> edges_;
    int line_ = 0;
};

}  // namespace

TriangleMesh read_mesh(const std::string& file) {
    InputFile in(file, largest_mesh_file);
    return read_mesh(in, file);
}

TriangleMesh read_mesh(std::istream& in, const std::string& file) { return MeshReader(in, file).read(); }

}  // namespace drape
