// The kernels over particles, on every kind of vector that this processor has, and on none. plain_core_test.cpp
// compares what is made of them with the plain core.

#include "bounds/kernels/patch_kernels.h"

#include <gtest/gtest.h>

#include <cstring>

#include "drape/bounds/cloth_quadtree.h"
#include "support/cloths.h"
#include "support/vector_kinds.h"

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

TEST(PatchKernels, GiveTheSameBitsWithEveryKindOfVector) {
    std::array<Vec3, 7> centres;
    for (int k = 0; k < 7; ++k) centres[static_cast<std::size_t>(k)] = Vec3(0.1 * k, 0.3 - 0.2 * k, 0.05 * k);
    int kinds = 0, differences = 0;
    for_each_patch([&](const Patch& patch, const Patch& before) {
        const Answers best = ask(patch, before, centres);
        kinds = test::with_every_kind_of_vector([&](const char*) {
            const Answers answers = ask(patch, before, centres);
            differences += std::memcmp(&answers, &best, sizeof best) != 0;
        });
    });
    EXPECT_EQ(differences, 0);
    EXPECT_GE(kinds, 2) << "this processor has no vectors to compare with";
}

}  // namespace
}  // namespace drape
