#include <algorithm>
#include <limits>
#include <numeric>

#include "drape/contact/closest_point.h"
#include "sheets.h"

namespace drape::peers {
namespace {

using Corners = std::array<Vec3, 3>;

/// Of two triangles that do not cross, whose closest points are those of a corner and a triangle, or of two edges.
Real distance(const Corners& a, const Corners& b) {
    Real square = std::numeric_limits<Real>::infinity();
    const auto look = [&square](const Vec3& offset) { square = std::min(square, offset.squaredNorm()); };
    for (std::size_t i = 0; i < 3; ++i) {
        look(closest_point_on_triangle(a[i], b[0], b[1], b[2]).point - a[i]);
        look(closest_point_on_triangle(b[i], a[0], a[1], a[2]).point - b[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            look(closest_of_segments(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]).offset);
        }
    }
    return std::sqrt(square);
}

Corners corners_of(const Sheets& sheets, const Points& x, int triangle) {
    const auto [a, b, c] = sheets.corners[static_cast<std::size_t>(triangle)];
    return {x.row(a).transpose(), x.row(b).transpose(), x.row(c).transpose()};
}

}  // namespace

void find_all_pairs(const Sheets& sheets, SheetFrame& frame) {
    std::vector<Aabb> boxes;
    make_boxes(sheets, frame.x, boxes);
    const auto box = [&boxes](int triangle) -> const Aabb& { return boxes[static_cast<std::size_t>(triangle)]; };
    std::vector<int> along_x(boxes.size());
    std::iota(along_x.begin(), along_x.end(), 0);
    std::ranges::sort(along_x, {}, [&](int triangle) { return box(triangle).low.x(); });
    // Twice the thickness: rounding is to play no part in where a row of comparisons ends
    for (auto a = along_x.begin(); a != along_x.end(); ++a) {
        const Real end = box(*a).high.x() + 2 * sheets.thickness;
        for (auto b = a + 1; b != along_x.end() && box(*b).low.x() <= end; ++b) {
            if (!meet(box(*a), box(*b), sheets.thickness) || sheets.share_particle(*a, *b)) continue;
            frame.boxes.push_back(in_order(*a, *b));
        }
    }
    std::ranges::sort(frame.boxes);
    std::ranges::copy_if(frame.boxes, std::back_inserter(frame.near), [&](const TrianglePair& pair) {
        const auto first = corners_of(sheets, frame.x, pair.first), second = corners_of(sheets, frame.x, pair.second);
        return distance(first, second) <= sheets.thickness;
    });
}

}  // namespace drape::peers
