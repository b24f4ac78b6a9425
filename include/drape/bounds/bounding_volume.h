#pragma once

#include <concepts>
#include <span>
#include <string_view>

#include "drape/base/real.h"
#include "drape/bounds/outlines.h"
#include "drape/model/ball.h"

namespace drape {

/// The particles of a rectangle of cells, as seen by a volume's fit: `rows` rows of `columns` particles, the first at
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

struct BoundingSphere;

/// What a hierarchy needs of a volume. `fit` contains every particle of the patch, and so its triangles; `merge`
/// contains every part. `overlaps` is true whenever the ball has a point in common with the volume and errs towards
/// true by the rounding; a cloth of some thickness is tested by a ball grown by it. `sphere` contains the volume.
/// `outline` appends the volume's shape for drawing.
template <class V>
concept BoundingVolume = requires(const V volume, const Patch& patch, std::span<const V> parts, const Ball& ball,
                                  NodeState state, Outlines& outlines) {
    { V::fit(patch) } -> std::same_as<V>;
    { V::merge(parts) } -> std::same_as<V>;
    { volume.overlaps(ball) } -> std::same_as<bool>;
    { volume.sphere() } -> std::same_as<BoundingSphere>;
    volume.outline(state, outlines);
    { V::name } -> std::convertible_to<std::string_view>;
};

}  // namespace drape
