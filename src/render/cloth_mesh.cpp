#include "cloth_mesh.h"

#include <Eigen/Geometry>
#include <cmath>

#include "drape/model/stencils.h"

namespace drape {

namespace {

// From left to right, which Eigen does not promise
float dot(const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void fill_hollows(const ClothModel& model, ClothVertex* vertices) {
    // A fold of this radius is as dark as any: light comes in from half of all sides or less
    constexpr float radius = 0.04f;
    const Grid& grid = model.grid;
    const auto hx = static_cast<float>(model.hx), hy = static_cast<float>(model.hy);
    for (int j = 1; j + 1 < grid.ny; ++j) {
        for (int i = 1; i + 1 < grid.nx; ++i) {
            ClothVertex& vertex = vertices[grid.particle(i, j)];
            const auto bent = [&](int before, int after, float spacing) {
                const Eigen::Vector3f both =
                    vertices[before].position - vertex.position + (vertices[after].position - vertex.position);
                return dot(both, vertex.normal) / (spacing * spacing);
            };
            const float curvature = bent(grid.particle(i - 1, j), grid.particle(i + 1, j), hx) +
                                    bent(grid.particle(i, j - 1), grid.particle(i, j + 1), hy);
            vertex.hollow = std::clamp(radius * curvature, -1.0f, 1.0f);
        }
    }
}

}  // namespace

void fill_cloth_vertices(const ClothView& cloth, int number, Real blend, ClothVertex* vertices) {
    const Grid& grid = cloth.model.grid;
    const Points& now = cloth.x;
    const Points& before = cloth.previous.rows() == now.rows() ? cloth.previous : now;

    // Positions, as `drawn_particle` has them, at a fifth of its cost
    for (int p = 0; p < grid.particles(); ++p) {
        for (int axis = 0; axis < 3; ++axis) {
            const Real x = before(p, axis) + blend * (now(p, axis) - before(p, axis));
            vertices[p].position[axis] = static_cast<float>(x);
        }
        vertices[p].value = 0;
        vertices[p].pinned = p == cloth.grabbed ? 2.0f : cloth.model.pinned(p) ? 1.0f : 0.0f;
    }

    // Normals: across the neighbours along the row and along the column
    const auto hx = static_cast<float>(cloth.model.hx), hy = static_cast<float>(cloth.model.hy);
    const float width = hx * static_cast<float>(grid.nx - 1), height = hy * static_cast<float>(grid.ny - 1);
    const auto at = [&](int p) -> const Eigen::Vector3f& { return vertices[p].position; };
    for (int j = 0; j < grid.ny; ++j) {
        const int above = std::max(j - 1, 0), below = std::min(j + 1, grid.ny - 1);
        for (int i = 0; i < grid.nx; ++i) {
            const int left = std::max(i - 1, 0), right = std::min(i + 1, grid.nx - 1);
            ClothVertex& vertex = vertices[grid.particle(i, j)];
            const Eigen::Vector3f row = at(grid.particle(right, j)) - at(grid.particle(left, j));
            const Eigen::Vector3f column = at(grid.particle(i, below)) - at(grid.particle(i, above));
            const Eigen::Vector3f across = column.cross(row);
            const float length = std::sqrt(dot(across, across));
            vertex.normal = Eigen::Vector3f::UnitY();
            if (length > 1e-20f) vertex.normal = across / length;
            vertex.hollow = 0;
            vertex.place = {hx * static_cast<float>(i), hy * static_cast<float>(j), width, height};
            vertex.number = static_cast<float>(number);
        }
    }
    fill_hollows(cloth.model, vertices);
}

std::vector<std::uint32_t> triangle_indices(std::span<const Grid> grids) {
    std::vector<std::uint32_t> indices;
    int first = 0;
    for (const Grid& grid : grids) {
        for (int t = 0; t < grid.triangles(); ++t) {
            std::array<int, 3> corners = grid.triangle_corners(t);
            if (t % 2 == 1) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            for (const int corner : corners) indices.push_back(static_cast<std::uint32_t>(first + corner));
        }
        first += grid.particles();
    }
    return indices;
}

SpringIndices spring_indices(std::span<const Grid> grids) {
    SpringIndices springs;
    for (std::size_t kind = 0; kind < springs.counts.size(); ++kind) {
        const std::size_t before = springs.ends.size();
        int first = 0;
        for (const Grid& grid : grids) {
            for (const auto& [di, dj] : {spring_directions[2 * kind], spring_directions[2 * kind + 1]}) {
                SpringStencil{di, dj, {}, 0}.for_each(grid, [&](int a, int b) {
                    for (const int end : {a, b}) springs.ends.push_back(static_cast<std::uint32_t>(first + end));
                });
            }
            first += grid.particles();
        }
        springs.counts[kind] = static_cast<int>((springs.ends.size() - before) / 2);
    }
    return springs;
}

}  // namespace drape
