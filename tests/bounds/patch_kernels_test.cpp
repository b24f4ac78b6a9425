// The kernels over particles, on every kind of vector that this processor has, and on none.

#include "bounds/kernels/patch_kernels.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstring>

#include "drape/bounds/cloth_quadtree.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// Everything that the kernels say about a patch.
struct Answers {
    kernels::PatchSums sums;
    BoundingSphere sphere;
    Aabb box;
    std::array<Real, 7> squares{};
    Real displacement = 0;
};

Answers ask(const Patch& patch, const Patch& before, std::span<const Vec3, 7> centres) {
    Answers answers{.sums = kernels::sums(patch),
                    .sphere = sphere_fit_of(SphereFit::Centroid, Kernels::Vector)(patch),
                    .box = fits_of<Aabb>({}).patch(patch)};
    kernels::raise_to_farthest(patch, centres.data(), 7, answers.squares.data());
    answers.displacement = kernels::largest_displacement_square(patch, before);
    return answers;
}

Patch part_of(const Points& x, const Grid& grid, int columns, int rows) {
    return {x.col(0).data() + 1, x.col(1).data() + 1, x.col(2).data() + 1, columns, rows, grid.nx};
}

/// Patches of all widths up to three vectors, with their neighbours in memory.
template <class Visit>
void for_each_patch(Visit visit) {
    std::mt19937 random(31);
    for (int columns = 2; columns <= 40; ++columns) {
        for (const int rows : {2, 3, 8, 17}) {
            const Grid grid{columns + 3, rows};
            const Points x = test::random_cloth(grid, random), before = test::random_cloth(grid, random);
            visit(part_of(x, grid, columns, rows), part_of(before, grid, columns, rows));
        }
    }
}

std::array<Vec3, 7> some_centres() {
    std::array<Vec3, 7> centres;
    for (int k = 0; k < 7; ++k) centres[static_cast<std::size_t>(k)] = Vec3(0.1 * k, 0.3 - 0.2 * k, 0.05 * k);
    return centres;
}

TEST(PatchKernels, SayWhatPlainLoopsSay) {
    const auto centres = some_centres();
    for_each_patch([&](const Patch& patch, const Patch& before) {
        Vec3 inner = Vec3::Zero(), right = Vec3::Zero(), below = Vec3::Zero();
        Vec3 low = patch.at(0, 0), high = low;
        std::array<Real, 7> squares{};
        Real displacement = 0;
        for (int j = 0; j < patch.rows; ++j) {
            for (int i = 0; i < patch.columns; ++i) {
                const Vec3 p = patch.at(i, j);
                if (i + 1 < patch.columns && j + 1 < patch.rows) inner += p;
                if (i + 1 == patch.columns && j + 1 < patch.rows) right += p;
                if (i + 1 < patch.columns && j + 1 == patch.rows) below += p;
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
                for (std::size_t k = 0; k < 7; ++k) {
                    squares[k] = std::max(squares[k], (p - centres[k]).squaredNorm());
                }
                displacement = std::max(displacement, (p - before.at(i, j)).squaredNorm());
            }
        }
        const Answers answers = ask(patch, before, centres);
        EXPECT_LT((answers.sums.inner - inner).norm(), 1e-12);
        EXPECT_LT((answers.sums.right - right).norm(), 1e-12);
        EXPECT_LT((answers.sums.below - below).norm(), 1e-12);
        EXPECT_EQ(answers.box.low, low);
        EXPECT_EQ(answers.box.high, high);
        for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(answers.squares[k], squares[k], 1e-14);
        EXPECT_NEAR(answers.displacement, displacement, 1e-14);
    });
}

TEST(PatchKernels, GiveTheSameBitsWithEveryKindOfVector) {
    const auto centres = some_centres();
    const std::int64_t all = hwy::SupportedTargets();
    int kinds = 0, differences = 0;
    for_each_patch([&](const Patch& patch, const Patch& before) {
        const Answers best = ask(patch, before, centres);
        kinds = 0;
        for (std::int64_t targets = all; targets != 0; targets &= targets - 1) {
            hwy::SetSupportedTargetsForTest(targets & -targets);
            const Answers answers = ask(patch, before, centres);
            differences += std::memcmp(&answers, &best, sizeof best) != 0;
            ++kinds;
        }
        hwy::SetSupportedTargetsForTest(0);
    });
    EXPECT_EQ(differences, 0);
    EXPECT_GE(kinds, 2) << "this processor has no vectors to compare with";
}

}  // namespace
}  // namespace drape
