#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
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
    std::uint32_t* fill(const Grid& grid, const Vertices& vertices, const Viewpoint& from, std::uint32_t* indices) {
        seen_.resize(static_cast<std::size_t>(grid.particles()));
        for (std::size_t p = 0; p < seen_.size(); ++p) {
            const ClothVertex& particle = vertices.particles[p];
            const Eigen::Vector3f to_eye = from.eye - particle.position;
            const float per_distance = 1 / std::max(to_eye.norm(), 1e-3f);
            seen_[p] = {to_eye.dot(particle.normal) * per_distance, from.pixels * per_distance};
        }
        divide_edges(grid, vertices);
        for (int j = 0; j + 1 < grid.ny; ++j) {
            for (int i = 0; i + 1 < grid.nx; ++i) {
                const int a = grid.particle(i, j), b = a + 1, c = a + grid.nx, d = c + 1;
                const int across = 3 * a + 2;
                indices = divide_triangle(vertices, {a, c, b}, {3 * a + 1, across, 3 * a}, indices);
                indices = divide_triangle(vertices, {c, d, b}, {3 * c, 3 * b + 1, across}, indices);
            }
        }
        return indices;
    }

    /// Writes the cloth's border as lines through the middles of the last `fill`: two for an edge, two indices each.
    /// @param end before which they are written
    /// @return where they start
    std::uint32_t* fill_hem(const Grid& grid, const Vertices& vertices, std::uint32_t* end) const {
        const auto add = [&](int p, int stride, int number) {
            const int edge = middles_each * p + number;
            const auto a = vertices.first_particle + static_cast<std::uint32_t>(p);
            const auto b = a + static_cast<std::uint32_t>(stride);
            const bool divided = divided_[static_cast<std::size_t>(edge)] != 0;
            const auto middle = divided ? vertices.first_middle + static_cast<std::uint32_t>(edge) : b;
            for (const std::uint32_t vertex : {a, middle, middle, b}) *--end = vertex;
        };
        const int last_row = grid.particle(0, grid.ny - 1), last_column = grid.nx - 1;
        for (int p = 0; p < last_column; ++p) add(p, 1, 0), add(last_row + p, 1, 0);
        for (int p = 0; p < last_row; p += grid.nx) add(p, grid.nx, 1), add(p + last_column, grid.nx, 1);
        return end;
    }

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

    // The outline is near an edge if the normal at one of its ends is no more than this off the picture's plane, as a
    // cosine; from half of it on, all of the cubic's bend is drawn
    static constexpr float near_outline = 0.4f;

    // A bend that is not seen, with the samples that a pixel has [pixel]
    static constexpr float unseen = 0.3f;

    void divide_edges(const Grid& grid, const Vertices& vertices) {
        farthest_ = 0;
        divided_.assign(middles_each * static_cast<std::size_t>(grid.particles()), 0);
        for (int j = 0; j < grid.ny; ++j) {
            const bool first_row = j == 0, last_row = j + 1 == grid.ny;
            for (int i = 0; i < grid.nx; ++i) {
                const bool first_column = i == 0, last_column = i + 1 == grid.nx;
                const bool one_right = !last_column, two_right = i + 2 < grid.nx;
                const bool one_down = !last_row, two_down = j + 2 < grid.ny;
                const int p = grid.particle(i, j);
                const auto try_edge = [&](int number, const Edge& edge) {
                    const int place = middles_each * p + number;
                    divided_[static_cast<std::size_t>(place)] =
                        divide(edge, vertices.particles, vertices.middles[place]);
                };
                if (one_right) try_edge(0, {p, p + 1, !first_column, two_right, first_row || last_row});
                if (one_down) try_edge(1, {p, p + grid.nx, !first_row, two_down, first_column || last_column});
                if (one_right && one_down)
                    try_edge(2, {p + 1, p + grid.nx, two_right && !first_row, !first_column && two_down, false});
            }
        }
    }

    // @return false if it stays straight
    [[nodiscard]] bool divide(const Edge& edge, const ClothVertex* particles, ClothVertex& middle) {
        // None of the bend is drawn far from the outline, so that it comes and goes without a jump
        const Seen &from = seen_[static_cast<std::size_t>(edge.from)], &to = seen_[static_cast<std::size_t>(edge.to)];
        const bool turns = from.facing * to.facing <= 0;
        const float facing = edge.is_border || turns ? 0 : std::min(std::abs(from.facing), std::abs(to.facing));
        if (facing >= near_outline) return false;
        const float part = std::min(2 - 2 * facing / near_outline, 1.0f);

        // By how much the cubic is off the middle; without a particle beyond one end, the parabola
        const int stride = edge.to - edge.from;
        const ClothVertex &a = particles[edge.from], &b = particles[edge.to];
        Eigen::Vector3f bend = Eigen::Vector3f::Zero();
        if (edge.has_before) bend += 2 * a.position - b.position - particles[edge.from - stride].position;
        if (edge.has_after) bend += 2 * b.position - a.position - particles[edge.to + stride].position;
        bend *= part / (edge.has_before && edge.has_after ? 16 : 8);
        const float off = std::sqrt(bend[0] * bend[0] + bend[1] * bend[1] + bend[2] * bend[2]) * from.pixels;
        if (!(off > unseen)) return false;
        farthest_ = std::max(farthest_, off);

        middle.position = (a.position + b.position) / 2 + bend;
        middle.normal = (a.normal + b.normal) / 2;
        middle.pinned = 0;
        middle.value = (a.value + b.value) / 2;
        middle.hollow = (a.hollow + b.hollow) / 2;
        middle.place = {(a.place[0] + b.place[0]) / 2, (a.place[1] + b.place[1]) / 2, a.place[2], a.place[3]};
        middle.number = a.number;
        return true;
    }

    // Into two, three or four where its edges are divided; edge k leads from corner k to the next
    [[nodiscard]] std::uint32_t* divide_triangle(const Vertices& vertices, const std::array<int, 3>& corners,
                                                 const std::array<int, 3>& edges, std::uint32_t* indices) const {
        std::array<std::uint32_t, 6> numbers;
        unsigned divided = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = vertices.first_particle + static_cast<std::uint32_t>(corners[k]);
            numbers[3 + k] = vertices.first_middle + static_cast<std::uint32_t>(edges[k]);
            divided |= unsigned{divided_[static_cast<std::size_t>(edges[k])]} << k;
        }

        // Its parts by which of the edges are divided: from corners, 0 to 2, and from the middles of edges, 3 to 5
        constexpr std::array<std::string_view, 8> parts{"012",    "032312",    "140420",    "032342314",
                                                        "251501", "251531503", "140450425", "035314542345"};
        for (const char vertex : parts[divided]) *indices++ = numbers[static_cast<std::size_t>(vertex - '0')];
        return indices;
    }

    std::vector<Seen> seen_;             ///< of particles
    std::vector<std::uint8_t> divided_;  ///< 1 for the edges that are, in the order of the middles
    float farthest_ = 0;
};

}  // namespace drape
