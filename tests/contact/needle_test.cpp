// Triangles from well shaped to none at all, against arithmetic of twice the digits. Built in both precisions.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "drape/contact/closest_point.h"
#include "drape/contact/detection.h"

namespace drape {
namespace {

__extension__ using Quad = __float128;

using QuadPoint = Eigen::Matrix<Quad, 3, 1>;

Quad square_to_segment(const QuadPoint& p, const QuadPoint& a, const QuadPoint& b) {
    const QuadPoint side = b - a;
    const Quad length = side.dot(side);
    const Quad t = length > 0 ? std::clamp<Quad>((p - a).dot(side) / length, 0, 1) : 0;
    const QuadPoint off = a + t * side - p;
    return off.dot(off);
}

long double true_distance(const Vec3& at, const std::array<Vec3, 3>& corners) {
    const QuadPoint p = at.cast<Quad>(), a = corners[0].cast<Quad>(), b = corners[1].cast<Quad>(),
                    c = corners[2].cast<Quad>();
    const QuadPoint n = (b - a).cross(c - a);
    const Quad area = n.dot(n), beyond = (p - a).dot(n);
    const bool over = area > 0 && n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                      n.dot((a - c).cross(p - c)) >= 0;
    const Quad square =
        over ? beyond * beyond / area
             : std::min({square_to_segment(p, a, b), square_to_segment(p, b, c), square_to_segment(p, c, a)});
    return std::sqrt(static_cast<long double>(square));
}

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// Triangles of about unit size, thinner and thinner, with a point near them or far.
class Needles {
public:
    /// @param width how high the triangle is, or how long its shortest side
    void draw(Real width) {
        const Vec3 a = random_() % 2 == 0 ? point() : Vec3(0, 0, 0), b = a + point();
        switch (random_() % 4) {
            case 0:  // an apex over the side
                corners = {a, b, a + (b - a) * (unit(random_) + 1) / 2 + width * point()};
                break;
            case 1:  // beyond it
                corners = {a, b, a + 2 * unit(random_) * (b - a) + width * point()};
                break;
            case 2:  // a short side
                corners = {a, b, a + width * point()};
                break;
            default:  // small in all
                corners = {a, a + width * point(), a + width * point()};
        }
        std::shuffle(corners.begin(), corners.end(), random_);
        // Far away, near the triangle, or nearly in it
        Real u = (unit(random_) + 1) / 2, v = (unit(random_) + 1) / 2;
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Real off = std::array{Real(1), width, Real(1e-3), Real(0)}[random_() % 4];
        p = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]) + off * point();
    }

    /// The largest coordinate, for the points themselves are rounded; half of them are about the origin.
    [[nodiscard]] Real size() const {
        Real largest = p.cwiseAbs().maxCoeff();
        for (const Vec3& corner : corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
        return largest;
    }

    Vec3 p;
    std::array<Vec3, 3> corners;

private:
    Vec3 point() { return {unit(random_), unit(random_), unit(random_)}; }

    std::mt19937 random_{19};
    std::uniform_real_distribution<Real> unit{-1, 1};
};

TEST(ClosestPoint, IsExactToRoundingForEveryTriangle) {
    Needles needle;
    for (int decade = 0; decade <= 17; ++decade) {
        const Real width = decade == 17 ? Real(0) : std::pow(Real(10), static_cast<Real>(-decade));
        long double worst = 0;
        for (int round = 0; round < 10'000; ++round) {
            needle.draw(width);
            const auto& [a, b, c] = needle.corners;
            const ClosestPoint closest = closest_point_on_triangle(needle.p, a, b, c);
            const auto& w = closest.barycentric;
            const Real size = needle.size();
            const long double off = (closest.point - needle.p).norm() - true_distance(needle.p, needle.corners);
            worst = std::max(worst, std::abs(off) / size);
            ASSERT_LE((w[0] * a + w[1] * b + w[2] * c - closest.point).norm(), 64 * epsilon * size);
            ASSERT_TRUE(w[0] >= -8 * epsilon && w[1] >= -8 * epsilon && w[2] >= -8 * epsilon);
        }
        EXPECT_LE(worst / epsilon, 40) << "triangles 1e-" << decade << " thin";
    }
}

// A cloth of one cell, so thin that its triangles were taken for their edges, or a point inside for another
TEST(TouchedTriangles, OfANeedleAreThoseWithinTheRadius) {
    const Grid grid{2, 2};
    const std::vector<CellRange> all{all_cells(grid)};
    Needles needle;
    std::vector<int> touched;
    std::vector<ContactRow> contacts;
    for (int decade = 1; decade <= 16; ++decade) {
        for (int round = 0; round < 2000; ++round) {
            needle.draw(std::pow(Real(10), static_cast<Real>(-decade)));
            Points x(4, 3);
            for (int corner = 0; corner < 3; ++corner) {
                x.row(corner) = needle.corners[static_cast<std::size_t>(corner)].transpose();
            }
            x.row(3) = x.row(static_cast<int>(round % 3));
            const auto distance = static_cast<Real>(true_distance(needle.p, needle.corners));
            const Real margin = 100 * epsilon * needle.size() + 16 * epsilon * distance;
            const auto touches = [&](Real radius) {
                find_touched_triangles(grid, x, {.centre = needle.p, .radius = radius}, 0, all, touched,
                                       Kernels::Vector);
                contacts.clear();
                find_contacts({grid, x, x}, {.centre = needle.p, .radius = radius}, {}, all, contacts, Kernels::Vector);
                const bool found = std::ranges::count(touched, 0) == 1;
                EXPECT_TRUE(!found || !contacts.empty());
                return found;
            };
            ASSERT_TRUE(touches(distance + margin)) << decade;
            if (distance > margin) {
                ASSERT_FALSE(touches(distance - margin)) << decade;
            }
        }
    }
}

}  // namespace
}  // namespace drape
