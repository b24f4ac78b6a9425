#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "drape/contact/solid_shape.h"

namespace drape {

inline constexpr std::uintmax_t largest_mesh_file = 16 * 1024 * 1024;  // bytes
inline constexpr std::size_t longest_mesh_line = 4 * 1024;

/// Takes the points and triangles of a mesh from a reader, and sees that it is a closed one. What it refuses is an
/// `InputError` that names the file and the place in it.
class MeshBuilder {
public:
    /// @param unit of what places are counted in: "" for lines, "byte " for bytes
    MeshBuilder(std::string file, std::string unit) : file_(std::move(file)), unit_(std::move(unit)) {}

    /// From here on, what is read is at this place.
    void go_to(std::uintmax_t place) { place_ = place; }

    /// A coordinate within its range.
    /// @param what the point is called in the file
    /// @param text what an error says of it
    [[nodiscard]] Real coordinate(std::string_view what, double value, std::string_view text) const;
    void add_point(const Vec3& point);
    /// @param what it is called in the file
    void add_triangle(std::string_view what, const std::array<int, 3>& corners);
    [[nodiscard]] const std::vector<Vec3>& points() const { return mesh_.points; }

    /// The mesh, if it is closed, of one orientation, and not inside out.
    TriangleMesh finish(std::string_view what);

    [[noreturn]] void fail(const std::string& message) const;
    [[noreturn]] void fail_line_length() const;

private:
    /// A triangle's side from corner to corner, and where it was read.
    struct DirectedEdge {
        int from, to;
        std::uintmax_t place;
    };

    void check_closed(std::string_view what);
    void check_outward() const;
    [[noreturn]] void fail_at(std::string_view what, const DirectedEdge& edge, const std::string& why);

    std::string file_, unit_;
    std::uintmax_t place_ = 0;
    TriangleMesh mesh_;
    std::vector<DirectedEdge> edges_;
};

/// The next word of a line, which is taken off it.
std::string_view next_word(std::string_view& line);

/// The point that the next three words of a line are.
/// @param what it is called in the file
Vec3 read_point(const MeshBuilder& mesh, std::string_view what, std::string_view rest);

}  // namespace drape
