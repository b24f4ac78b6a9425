#pragma once

#include <concepts>
#include <limits>
#include <span>
#include <utility>

#include "drape/base/real.h"
#include "drape/model/ball.h"

namespace drape {

/// The particles of a rectangle of cells, as a volume's fit sees them: `rows` rows of `columns` particles, the first at
/// (x[0], y[0], z[0]), the start of each next row `stride` further on.
/// Invariant: a cell has two particles to each side, so columns >= 2 and rows >= 2, but for hand-made patches of
/// points.
struct Patch {
    const Real* x;
    const Real* y;
    const Real* z;
    int columns;
    int rows;
    int stride;

    [[nodiscard]] int particles() const { return columns * rows; }
    [[nodiscard]] Vec3 at(int i, int j) const { return {x[j * stride + i], y[j * stride + i], z[j * stride + i]}; }
};

/// Calls visit(p) with the position of each particle of a patch, row by row.
template <class Visit>
void for_each_particle(const Patch& patch, Visit visit) {
    for (int j = 0; j < patch.rows; ++j) {
        for (int i = 0; i < patch.columns; ++i) visit(patch.at(i, j));
    }
}

/// Makes up for the rounding of a distance and of its use.
inline constexpr Real rounded_up = 1 + 8 * std::numeric_limits<Real>::epsilon();

struct BoundingSphere;

/// What a hierarchy needs of a volume. `fit` contains every particle of the patch, and so its triangles: it is the
/// plain one, `fits_of` has that of the vector kernels too. `merge` contains every child. `overlaps` is true whenever
/// the ball has a point in common with the volume and errs towards true by the rounding; a cloth of some thickness is
/// tested by a ball grown by it. `comes_within` is true whenever two volumes have points no farther from each other
/// than a margin, and errs towards true. `sphere` contains the volume. `start` is the smallest volume from which
/// `include` grows one about the particles of a patch: each time to contain one more of them, and all that it has
/// contained.
template <class V>
concept BoundingVolume = requires(V volume, const Patch& patch, std::span<const V> children, const Ball& ball,
                                  const V& other, Real margin, const Vec3& p) {
    { V::fit(patch) } -> std::same_as<V>;
    { V::merge(children) } -> std::same_as<V>;
    { std::as_const(volume).overlaps(ball) } -> std::same_as<bool>;
    { std::as_const(volume).comes_within(other, margin) } -> std::same_as<bool>;
    { V::start(patch) } -> std::same_as<V>;
    { volume.include(p) } -> std::same_as<void>;
    { std::as_const(volume).sphere() } -> std::same_as<BoundingSphere>;
};

}  // namespace drape
