#include "stl_file.h"

#include <bit>
#include <iterator>
#include <map>
#include <sstream>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "mesh_builder.h"

namespace drape {
namespace {

// A binary file: 80 bytes of any kind, the number of triangles, and of each a normal, three corners and two more bytes
constexpr std::size_t header_size = 80, counted_header_size = 84, facet_size = 50, number_size = 4;

/// A mesh whose triangles come with the positions of their corners.
class CornerMesh {
public:
    CornerMesh(const std::string& file, const std::string& unit) : mesh(file, unit) {}

    void add(const std::array<Vec3, 3>& corners) {
        mesh.add_triangle("facet", {number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
    }

    MeshBuilder mesh;

private:
    int number_of(const Vec3& p) {
        const auto [found, is_new] =
            numbers_.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.points().size()));
        if (is_new) mesh.add_point(p);
        return found->second;
    }

    std::map<std::array<Real, 3>, int> numbers_;
};

/// The lines of a text, one after the other: words that have to be there.
class StlText {
public:
    StlText(const std::string& text, const std::string& file) : in_(text), corners_(file, "") {}

    TriangleMesh read() {
        bool within = false;  // a solid
        for (;;) {
            const std::string_view word = next_line();
            if (word.empty()) break;
            const std::string_view wanted = within ? "facet" : "solid";
            if (within && word == "endsolid") {
                within = false;
            } else if (word != wanted) {
                refuse(word, within ? "'facet' or 'endsolid'" : "'solid'");
            } else if (within) {
                read_facet();
            } else {
                within = true;
            }
        }
        if (within) refuse({}, "'facet' or 'endsolid'");
        return corners_.mesh.finish("facet");
    }

private:
    /// The first word of the next line that has any; empty at the end of the file.
    std::string_view next_line() {
        for (;;) {
            corners_.mesh.go_to(++line_);
            const LineEnd end = read_line(in_, text_, longest_mesh_line);
            if (end == LineEnd::None) return {};
            if (end == LineEnd::TooLong) corners_.mesh.fail_line_length();
            rest_ = text_;
            const std::string_view word = next_word(rest_);
            if (!word.empty()) return word;
        }
    }

    void expect(std::string_view wanted) {
        const std::string_view word = next_line();
        if (word != wanted) refuse(word, "'" + std::string(wanted) + "'");
    }

    void read_facet() {
        expect("outer");
        std::array<Vec3, 3> corners;
        for (Vec3& corner : corners) {
            expect("vertex");
            corner = read_point(corners_.mesh, "vertex", rest_);
        }
        corners_.add(corners);
        expect("endloop");
        expect("endfacet");
    }

    [[noreturn]] void refuse(std::string_view word, const std::string& allowed) const {
        const std::string found = word.empty() ? "the file ends" : "'" + shortened(word) + "'";
        corners_.mesh.fail(found + ": allowed " + allowed + " here");
    }

    std::istringstream in_;
    CornerMesh corners_;
    std::string text_;
    std::string_view rest_;
    std::uintmax_t line_ = 0;
};

/// Four bytes, the lowest first.
std::uint32_t number_at(std::string_view bytes, std::size_t place) {
    std::uint32_t number = 0;
    for (std::size_t k = number_size; k-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[place + k]);
    return number;
}

std::uintmax_t size_of_binary(std::string_view bytes) {
    return counted_header_size + std::uintmax_t{facet_size} * number_at(bytes, header_size);
}

TriangleMesh read_binary(std::string_view bytes, const std::string& file) {
    CornerMesh corners(file, "byte ");
    for (std::size_t facet = counted_header_size; facet < bytes.size(); facet += facet_size) {
        std::array<Vec3, 3> points;
        std::size_t place = facet + 3 * number_size;  // after the normal
        for (Vec3& point : points) {
            for (int axis = 0; axis < 3; ++axis, place += number_size) {
                const auto value = static_cast<double>(std::bit_cast<float>(number_at(bytes, place)));
                corners.mesh.go_to(place);
                point[axis] = corners.mesh.coordinate("corner", value, real_text(value));
            }
        }
        corners.mesh.go_to(facet);
        corners.add(points);
    }
    return corners.mesh.finish("facet");
}

}  // namespace

TriangleMesh read_stl(std::istream& in, const std::string& file) {
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const bool is_counted = bytes.size() >= counted_header_size;
    if (is_counted && bytes.size() == size_of_binary(bytes)) return read_binary(bytes, file);
    std::string_view start = std::string_view(bytes).substr(0, bytes.find_first_of("\r\n"));
    if (next_word(start) == "solid" || !is_counted) return StlText(bytes, file).read();
    throw InputError(file + ": " + std::to_string(bytes.size()) + " bytes: allowed " +
                     std::to_string(size_of_binary(bytes)) + ", for the " +
                     std::to_string(number_at(bytes, header_size)) +
                     " triangles that byte 80 says a binary STL file has, or a text that begins with 'solid'");
}

}  // namespace drape
