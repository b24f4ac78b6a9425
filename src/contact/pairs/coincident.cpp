#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/grid_features.h"
#include "contact/tuning.h"
#include "drape/contact/closest_point.h"
#include "pair_tests.h"

namespace drape {
namespace {

/// No coordinate of a scene is larger [m].
constexpr Real largest_coordinate = Real(1e4);

/// Of what is computed from coordinates up to a size [m].
Real rounding_of(Real size) { return 64 * std::numeric_limits<Real>::epsilon() * size; }

/// Across a triangle or two edges, length 1; zero where that is no direction.
Vec3 across(const Vec3& u, const Vec3& v) {
    const Vec3 n = u.cross(v);
    const Real length = n.norm();
    return length > min_sine * u.norm() * v.norm() ? Vec3(n / length) : Vec3::Zero();
}

/// A triangle of which two particles are an edge.
int triangle_beside(const Grid& grid, int from, int to) {
    const auto [first, last] = std::minmax(from, to);
    const int i = first % grid.nx, j = first / grid.nx, cell = j * grid.cell_columns() + i;
    // At the far sides of the cloth it is the second one of the cell before
    if (last / grid.nx == j) return j < grid.cell_rows() ? 2 * cell : 2 * (cell - grid.cell_columns()) + 1;
    if (last - first == grid.nx) return i < grid.cell_columns() ? 2 * cell : 2 * (cell - 1) + 1;
    return 2 * (cell - 1);
}

/// The front of a feature: of the triangle itself, or of one beside a particle or an edge.
/// @param from, count its particles among those of the pair
Vec3 front_of(const ClothAt& cloth, const NearPair& pair, std::size_t from, std::size_t count) {
    const auto& particles = pair.features.particles;
    const int triangle = count == 3   ? pair.triangle
                         : count == 2 ? triangle_beside(cloth.grid, particles[from], particles[from + 1])
                                      : owner_of(cloth.grid, particles[from]);
    const auto [a, b, c] = cloth.grid.triangle_corners(triangle);
    const Vec3 p = position(cloth.x, a);
    return across(position(cloth.x, b) - p, position(cloth.x, c) - p);
}

/// The middle of the neighbours of a particle, along a row and along a column.
Vec3 middle_about(const ClothAt& cloth, int particle) {
    const int i = particle % cloth.grid.nx, j = particle / cloth.grid.nx;
    Vec3 sum = Vec3::Zero();
    int count = 0;
    const auto add = [&](bool exists, int neighbour) {
        if (exists) sum += position(cloth.x, neighbour), ++count;
    };
    add(i > 0, particle - 1);
    add(i + 1 < cloth.grid.nx, particle + 1);
    add(j > 0, particle - cloth.grid.nx);
    add(j + 1 < cloth.grid.ny, particle + cloth.grid.nx);
    return sum / static_cast<Real>(count);
}

}  // namespace

bool is_rounding(const ClothAt& first, const ClothAt& second, const NearPair& pair) {
    if (pair.distance > rounding_of(largest_coordinate)) return false;
    Real size = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const ClothAt& cloth = pair.features.feature_of(k) == 0 ? first : second;
        size = std::max(size, position(cloth.x, pair.features.particles[k]).cwiseAbs().maxCoeff());
    }
    return pair.distance <= rounding_of(size);
}

Vec3 separation_direction(const ClothAt& first, const ClothAt& second, const NearPair& pair) {
    const auto& particles = pair.features.particles;
    const auto second_at = static_cast<std::size_t>(pair.features.first_count);
    const auto of = [&](std::size_t k) -> const ClothAt& { return k < second_at ? first : second; };
    const auto at = [&](std::size_t k) { return position(of(k).x, particles[k]); };
    const Vec3 other_front = front_of(first, pair, 0, second_at);
    const Vec3 front = front_of(second, pair, second_at, 4 - second_at);
    Vec3 direction = second_at == 1 ? front : across(at(1) - at(0), at(3) - at(2));
    if (direction.isZero(0)) direction = front;
    if (direction.isZero(0)) direction = other_front;
    if (direction.isZero(0)) return {0, 1, 0};

    // Where the cloth about the first feature is
    Vec3 beside = Vec3::Zero();
    Real size = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (pair.weights[k] == 0) continue;
        const Vec3 middle = middle_about(of(k), particles[k]);
        beside += pair.signed_weight(k) * middle;
        size = std::max(size, middle.cwiseAbs().maxCoeff());
    }
    const Real side = beside.dot(direction);
    if (std::abs(side) > rounding_of(size)) return std::copysign(Real(1), side) * direction;

    // The front of the lower one looks to the other; where they are a fold, that of the other looks back
    const bool first_is_lower =
        first.number != second.number ? first.number < second.number : particles[0] < particles[second_at];
    const Vec3 wanted = first_is_lower ? Vec3(-other_front) : front;
    return wanted.dot(direction) < 0 ? Vec3(-direction) : direction;
}

}  // namespace drape
