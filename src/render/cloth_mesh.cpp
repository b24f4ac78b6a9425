#include "cloth_mesh.h"

#include <algorithm>
#include <cmath>

#include "drape/model/stencils.h"

namespace drape {

namespace {

struct Float3 {
    float x, y, z;
};

Float3 position(const ClothVertex& vertex) { return {vertex.position[0], vertex.position[1], vertex.position[2]}; }

Float3 difference(const ClothVertex& a, const ClothVertex& b) {
    const Float3 p = position(a), q = position(b);
    return {p.x - q.x, p.y - q.y, p.z - q.z};
}

Float3 cross(const Float3& a, const Float3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

void fill_cloth_vertices(const ClothView& cloth, Real blend, ClothVertex* vertices) {
    const Grid& grid = cloth.model.grid;
    const bool moving = cloth.previous.rows() == cloth.x.rows();
    const Points& now = cloth.x;
    const Points& before = moving ? cloth.previous : cloth.x;

    // Positions
    for (int p = 0; p < grid.particles(); ++p) {
        for (int axis = 0; axis < 3; ++axis) {
            const Real x = before(p, axis) + blend * (now(p, axis) - before(p, axis));
            vertices[p].position[axis] = static_cast<float>(x);
        }
        vertices[p].value = 0;
        vertices[p].pinned = p == cloth.held ? 2.0f : cloth.model.pinned(p) ? 1.0f : 0.0f;
    }

    // Normals: across the neighbours along the row and along the column
    for (int j = 0; j < grid.ny; ++j) {
        const int above = std::max(j - 1, 0), below = std::min(j + 1, grid.ny - 1);
        for (int i = 0; i < grid.nx; ++i) {
            const int left = std::max(i - 1, 0), right = std::min(i + 1, grid.nx - 1);
            const Float3 row = difference(vertices[grid.particle(right, j)], vertices[grid.particle(left, j)]);
            const Float3 column = difference(vertices[grid.particle(i, below)], vertices[grid.particle(i, above)]);
            Float3 n = cross(column, row);
            const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
            if (length > 1e-20f) {
                n = {n.x / length, n.y / length, n.z / length};
            } else {
                n = {0, 1, 0};
            }
            float* normal = vertices[grid.particle(i, j)].normal;
            normal[0] = n.x;
            normal[1] = n.y;
            normal[2] = n.z;
            vertices[grid.particle(i, j)].hollow = 0;
        }
    }
}

void fill_hollows(const ClothModel& model, ClothVertex* vertices) {
    // A fold of this radius is as dark as any: light comes in from half of all sides or less
    constexpr float radius = 0.04f;
    const Grid& grid = model.grid;
    const auto hx = static_cast<float>(model.hx), hy = static_cast<float>(model.hy);
    for (int j = 1; j + 1 < grid.ny; ++j) {
        for (int i = 1; i + 1 < grid.nx; ++i) {
            ClothVertex& vertex = vertices[grid.particle(i, j)];
            const auto bent = [&](int before, int after, float spacing) {
                const Float3 a = difference(vertices[before], vertex), b = difference(vertices[after], vertex);
                const float* n = vertex.normal;
                return ((a.x + b.x) * n[0] + (a.y + b.y) * n[1] + (a.z + b.z) * n[2]) / (spacing * spacing);
            };
            const float curvature = bent(grid.particle(i - 1, j), grid.particle(i + 1, j), hx) +
                                    bent(grid.particle(i, j - 1), grid.particle(i, j + 1), hy);
            vertex.hollow = std::clamp(radius * curvature, -1.0f, 1.0f);
        }
    }
}

void append_places(const ClothModel& model, std::vector<ClothPlace>& places) {
    const Grid& grid = model.grid;
    const auto hx = static_cast<float>(model.hx), hy = static_cast<float>(model.hy);
    const float width = hx * static_cast<float>(grid.nx - 1), height = hy * static_cast<float>(grid.ny - 1);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            places.push_back({hx * static_cast<float>(i), hy * static_cast<float>(j), width, height});
        }
    }
}

bool update_grids(const FrameView& view, std::vector<Grid>& grids) {
    const auto grid_of = [](const ClothView& cloth) { return cloth.model.grid; };
    if (std::ranges::equal(view.cloths, grids, {}, grid_of)) return false;
    grids.clear();
    for (const ClothView& cloth : view.cloths) grids.push_back(grid_of(cloth));
    return true;
}

std::vector<std::uint32_t> triangle_indices(std::span<const Grid> grids) {
    std::vector<std::uint32_t> indices;
    int first = 0;
    for (const Grid& grid : grids) {
        for (int t = 0; t < grid.triangles(); ++t) {
            std::array<int, 3> corners = grid.triangle_corners(t);
            if (t % 2 == 1) std::ranges::rotate(corners, corners.begin() + 1);
            for (const int corner : corners) indices.push_back(static_cast<std::uint32_t>(first + corner));
        }
        first += grid.particles();
    }
    return indices;
}

std::vector<std::uint32_t> coarse_triangle_indices(std::span<const Grid> grids, int step) {
    std::vector<std::uint32_t> indices;
    int first = 0;
    for (const Grid& grid : grids) {
        const auto cells = [step](int particles) { return (particles - 2 + step) / step; };
        const Grid coarse{cells(grid.nx) + 1, cells(grid.ny) + 1};
        for (const std::uint32_t corner : triangle_indices({&coarse, 1})) {
            const int p = static_cast<int>(corner);
            const int column = std::min(step * (p % coarse.nx), grid.nx - 1);
            const int row = std::min(step * (p / coarse.nx), grid.ny - 1);
            indices.push_back(static_cast<std::uint32_t>(first + row * grid.nx + column));
        }
        first += grid.particles();
    }
    return indices;
}

SpringIndices spring_indices(std::span<const Grid> grids) {
    SpringIndices springs;
    std::vector<std::uint32_t>* const kinds[] = {&springs.structural, &springs.shear, &springs.bend};
    int first = 0;
    for (const Grid& grid : grids) {
        for (std::size_t direction = 0; direction < spring_directions.size(); ++direction) {
            const auto [di, dj] = spring_directions[direction];
            SpringStencil{di, dj, {}, 0}.for_each(grid, [&](int a, int b) {
                for (const int end : {a, b}) kinds[direction / 2]->push_back(static_cast<std::uint32_t>(first + end));
            });
        }
        first += grid.particles();
    }
    return springs;
}

}  // namespace drape
