#include "mesh_file.h"

#include <filesystem>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "mesh_builder.h"
#include "stl_file.h"

// The reader is our own: tinyobjloader 2.0 takes a word that is no number for zero, names no line, and converts
// exponents by a function of the C library, whose last bit differs from processor to processor.

namespace drape {
namespace {

class ObjReader {
public:
    ObjReader(std::istream& in, const std::string& file) : in_(in), mesh_(file, "") {}

    TriangleMesh read() {
        std::string line;
        for (std::uintmax_t number = 1;; ++number) {
            mesh_.go_to(number);
            const LineEnd end = read_line(in_, line, longest_mesh_line);
            if (end == LineEnd::None) break;
            if (end == LineEnd::TooLong) mesh_.fail_line_length();
            read_element(line);
        }
        return mesh_.finish("f");
    }

private:
    void read_element(std::string_view rest) {
        const std::string_view kind = next_word(rest);
        if (kind == "v") mesh_.add_point(read_point(mesh_, "v", rest));
        if (kind == "f") read_face(rest);
    }

    /// The number of a corner, counted from 1, or back from the last point, -1.
    int corner_of(std::string_view word) {
        const auto count = static_cast<long long>(mesh_.points().size());
        const auto number = parse_integer(word.substr(0, word.find('/')));
        const bool known = number && ((*number >= 1 && *number <= count) || (*number <= -1 && *number >= -count));
        if (!known) {
            mesh_.fail("f: '" + shortened(word) + "': allowed points from 1 to " + std::to_string(count) +
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
            mesh_.fail("f: " + std::to_string(corners.size()) + " corners: allowed at least 3");
        }
        for (std::size_t k = 2; k < corners.size(); ++k) {
            mesh_.add_triangle("f", {corners[0], corners[k - 1], corners[k]});
        }
    }

    std::istream& in_;
    MeshBuilder mesh_;
};

}  // namespace

std::string mesh_extension(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension == ".stl" ? extension : ".obj";
}

TriangleMesh read_mesh(const std::string& file) {
    InputFile in(file, largest_mesh_file);
    return read_mesh(in, file);
}

TriangleMesh read_mesh(std::istream& in, const std::string& file) {
    return mesh_extension(file) == ".stl" ? read_stl(in, file) : ObjReader(in, file).read();
}

}  // namespace drape
