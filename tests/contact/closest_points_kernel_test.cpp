// The kernel of closest points against the plain code, on every kind of vector that this processor has, and on none.
// Built in both precisions.

#include "contact/kernels/closest_points.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <limits>
#include <random>

#include "drape/contact/closest_point.h"

namespace drape {
namespace {

using kernels::CellBatch;

/// A row of cells that fills a batch.
constexpr Grid cell_strip{static_cast<int>(CellBatch::size) + 1, 2};

/// How the corners of cells are drawn.
enum class DrawnCorners { Anywhere, OnALattice, NearlyOnALine, AtOnePoint };

/// On a lattice, right angles and equal distances are met exactly.
Points draw_cells(DrawnCorners corners, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    const auto step = [&] { return std::round(Real(1.5) * unit(random)); };
    Points x(cell_strip.particles(), 3);
    for (int p = 0; p < cell_strip.particles(); ++p) {
        const Vec3 free(unit(random), unit(random), unit(random));
        if (corners == DrawnCorners::Anywhere) x.row(p) = free.transpose();
        if (corners == DrawnCorners::OnALattice) x.row(p) << step(), step(), step();
        if (corners == DrawnCorners::NearlyOnALine) x.row(p) << free[0], Real(1e-3) * free[1], free[0];
        if (corners == DrawnCorners::AtOnePoint) x.row(p).setConstant(Real(0.25));
    }
    return x;
}

/// What the kernel says of one triangle of a cell.
struct KernelAnswer {
    ClosestPoint closest;
    Real square = 0;
};

KernelAnswer kernel_answer(const CellBatch& batch, std::size_t second, std::size_t k) {
    const CellBatch::Closest& all = batch.closest[second];
    const Vec3 point(all.point[0][k], all.point[1][k], all.point[2][k]);
    return {{point, {all.barycentric[0][k], all.barycentric[1][k], all.barycentric[2][k]}}, all.square[k]};
}

bool has_plain_bits(const KernelAnswer& answer, const Points& x, int triangle, const Vec3& p) {
    const auto [a, b, c] = cell_strip.triangle_corners(triangle);
    const ClosestPoint plain =
        closest_point_on_triangle(p, x.row(a).transpose(), x.row(b).transpose(), x.row(c).transpose());
    return answer.closest.point == plain.point && answer.closest.barycentric == plain.barycentric &&
           answer.square == (plain.point - p).squaredNorm();
}

/// @param count of cells in the batch
/// @param asked of the kernel in place of p: the planted fault
/// @return on how many triangles kernel and plain code differ
int disagreements(const Points& x, const Vec3& p, int count, const Vec3& asked) {
    CellBatch batch;
    for (int cell = 0; cell < count; ++cell) batch.add(cell_strip, x, cell, cell_strip.cell_corner(cell));
    kernels::find_closest_points(batch, asked);
    int different = 0;
    for (int triangle = 0; triangle < 2 * count; ++triangle) {
        const KernelAnswer answer =
            kernel_answer(batch, static_cast<std::size_t>(triangle % 2), static_cast<std::size_t>(triangle / 2));
        different += !has_plain_bits(answer, x, triangle, p);
    }
    return different;
}

int disagreements_of_all() {
    std::mt19937 random(37);
    std::uniform_real_distribution<Real> unit(-1, 1);
    int different = 0;
    for (const auto corners :
         {DrawnCorners::Anywhere, DrawnCorners::OnALattice, DrawnCorners::NearlyOnALine, DrawnCorners::AtOnePoint}) {
        for (int round = 0; round < 64; ++round) {
            const Points x = draw_cells(corners, random);
            const Vec3 free(unit(random), unit(random), unit(random));
            const Vec3 on_lattice = free.array().round().matrix() / 2;
            different += disagreements(x, free, round % 2 == 0 ? cell_strip.cells() : 1 + round / 2, free);
            different += disagreements(x, on_lattice, cell_strip.cells(), on_lattice);
        }
    }
    return different;
}

TEST(ClosestPointsKernel, HasTheBitsOfThePlainCodeOnEveryProcessor) {
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
        hwy::SetSupportedTargetsForTest(targets & -targets);
        EXPECT_EQ(disagreements_of_all(), 0) << hwy::TargetName(targets & -targets);
        hwy::SetSupportedTargetsForTest(0);
    }
}

/// The planted fault.
TEST(ClosestPointsKernel, IsCaughtWhenTheCentreIsOffByItsRounding) {
    std::mt19937 random(38);
    const Points x = draw_cells(DrawnCorners::Anywhere, random);
    const Vec3 p(Real(0.1), Real(0.2), Real(0.3)), off = p * (1 + 4 * std::numeric_limits<Real>::epsilon());
    EXPECT_GT(disagreements(x, p, cell_strip.cells(), off), cell_strip.cells());
}

}  // namespace
}  // namespace drape
