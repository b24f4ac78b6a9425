#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth_mesh.h"

namespace drape {

/// From where a picture is seen.
struct Viewpoint {
    Eigen::Vector3f eye;
    float pixels;  ///< that a metre takes at a distance of a metre
};

/// Draws outlines of cloth as curves. Where the cloth turns away from the eye, or ends, an edge between particles gets
/// a vertex in its middle, on the cubic through the particles, and the triangles on both sides are divided there: they
/// still meet, and the particles stay where they are. Normals and colours are as they would be on the straight edge, so
/// that nothing but the outline changes.
/// @cite catmull1974
class SmoothOutline {
public:
    /// More particles in all are drawn as they are: their edges are short.
    static constexpr std::size_t max_particles = 10'000;

    /// Middles that a particle has room for: of the edges to the next particle of its row, of its column, and across
    /// the cell, from corner b to c.
    static constexpr int middles_each = 3;

    /// Where the vertices of a cloth are, and which numbers they have in the buffer.
    struct Vertices {
        ClothVertex* particles;
        ClothVertex* middles;  ///< of which those that are used are written
        std::uint32_t first_particle, first_middle;
    };

    /// Writes the middles, and three indices for each of the triangles, counter-clockwise on the front.
    /// @return the end of the indices, of which there are at most 12 for a triangle of the grid
    /// @par Cost O(n), allocates only for a larger grid
    std::uint32_t* fill(const Grid& grid, const Vertices& vertices, const Viewpoint& from, std::uint32_t* indices);

    /// The farthest that a middle of the last fill is off its straight edge [pixel].
    [[nodiscard]] float farthest() const { return farthest_; }

private:
    struct Seen {
        float facing;  ///< cosine of the angle between the normal and the direction to the eye
        float pixels;  ///< that a metre takes there
    };
    struct Edge {
        int from, to;
        bool has_before, has_after;  ///< whether its line goes on to further particles
        bool is_border;              ///< of the cloth
    };

    void divide_edges(const Grid& grid, const Vertices& vertices);
    [[nodiscard]] bool divide(const Edge& edge, const ClothVertex* particles, ClothVertex& middle);
    [[nodiscard]] std::uint32_t* divide_triangle(const Vertices& vertices, std::array<int, 3> corners,
                                                 std::array<int, 3> edges, std::uint32_t* indices) const;

    std::vector<Seen> seen_;             ///< of particles
    std::vector<std::uint8_t> divided_;  ///< 1 for the edges that are, in the order of the middles
    float farthest_ = 0;
};

}  // namespace drape
