#include "drape/bounds/obb.h"

#include <Eigen/Geometry>

#include "drape/base/assert.h"

namespace drape {
namespace {

constexpr Real rounding_unit = std::numeric_limits<Real>::epsilon();

/// What of v is at right angles to a direction.
Vec3 upright(const Vec3& v, const Vec3& direction) { return v - v.dot(direction) * direction; }

/// The first axis along `along`, the second as near to `across` as can be. Where these do not say enough, the axes of
/// space do.
BoxAxes make_axes(const Vec3& along, const Vec3& across) {
    const Vec3 wanted = across.stableNormalized();
    Vec3 first = along.stableNormalized();
    if (first.isZero(0)) first = wanted;
    if (first.isZero(0)) first = Vec3::UnitX();
    Vec3 second = upright(wanted, first);
    if (second.norm() < Real(1e-3)) {
        int farthest = 0;
        first.cwiseAbs().minCoeff(&farthest);
        second = upright(Vec3::Unit(farthest), first);
    }
    second = upright(second.normalized(), first).normalized();
    BoxAxes axes;
    axes << first, second, first.cross(second);
    return axes;
}

/// The mean directions, from the first column to the last, and from the first row to the last: the sums of all steps
/// between neighbours along rows and along columns.
BoxAxes axes_of(const Patch& patch) {
    Vec3 along = Vec3::Zero(), across = Vec3::Zero();
    for (int j = 0; j < patch.rows; ++j) along += patch.at(patch.columns - 1, j) - patch.at(0, j);
    for (int i = 0; i < patch.columns; ++i) across += patch.at(i, patch.rows - 1) - patch.at(i, 0);
    return make_axes(along, across);
}

}  // namespace

Obb Obb::fit(const Patch& patch) {
    Obb box = start(patch);
    for_each_particle(patch, [&](const Vec3& p) {
        const Vec3 along = box.axes.transpose() * (p - box.origin);
        box.low = box.low.cwiseMin(along);
        box.high = box.high.cwiseMax(along);
    });
    box.grow_by_rounding();
    return box;
}

Obb Obb::start(const Patch& patch) {
    const Vec3 infinity = Vec3::Constant(std::numeric_limits<Real>::infinity());
    return {patch.at(0, 0), axes_of(patch), infinity, -infinity};
}

void Obb::include(const Vec3& p) {
    const Vec3 offset = p - origin, along = axes.transpose() * offset;
    const Vec3 rounding = Vec3::Constant(8 * rounding_unit * offset.cwiseAbs().sum());
    low = low.cwiseMin(along - rounding);
    high = high.cwiseMax(along + rounding);
}

namespace {

/// A box as the directions of another one see it: it extends as far from its middle as its edges do together.
struct SeenBox {
    Vec3 middle, half;
    Real rounding;
};

SeenBox seen_from(const Obb& frame, const Obb& box) {
    const BoxAxes turn = frame.axes.transpose() * box.axes;
    const Vec3 offset = box.origin - frame.origin;
    const Vec3 middle = frame.axes.transpose() * offset + turn * ((box.low + box.high) / 2);
    const Vec3 half = turn.cwiseAbs() * ((box.high - box.low) / 2);
    const Real size = offset.cwiseAbs().sum() + box.low.cwiseAbs().sum() + box.high.cwiseAbs().sum();
    return {middle, half, 16 * rounding_unit * size};
}

/// Whether a box keeps another farther away than a margin, along its own directions.
bool keeps_away(const Obb& box, const Obb& other, Real margin) {
    const auto [middle, half, rounding] = seen_from(box, other);
    const Real bound = margin * (1 + 16 * rounding_unit) + rounding;
    return (middle - half - box.high).maxCoeff() > bound || (box.low - middle - half).maxCoeff() > bound;
}

}  // namespace

bool Obb::comes_within(const Obb& other, Real margin) const {
    return !keeps_away(*this, other, margin) && !keeps_away(other, *this, margin);
}

void Obb::grow_by_rounding() {
    const Real rounding = 8 * rounding_unit * (high - low).sum();
    low.array() -= rounding;
    high.array() += rounding;
}

Obb Obb::merge(std::span<const Obb> children) {
    DRAPE_ASSERT(!children.empty());
    // The same axis of two boxes may point in opposite ways
    const BoxAxes& first = children[0].axes;
    Vec3 along = Vec3::Zero(), across = Vec3::Zero();
    for (const Obb& child : children) {
        const BoxAxes& axes = child.axes;
        along += axes.col(0).dot(first.col(0)) < 0 ? Vec3(-axes.col(0)) : Vec3(axes.col(0));
        across += axes.col(1).dot(first.col(1)) < 0 ? Vec3(-axes.col(1)) : Vec3(axes.col(1));
    }
    const Vec3 infinity = Vec3::Constant(std::numeric_limits<Real>::infinity());
    Obb all{children[0].origin, make_axes(along, across), infinity, -infinity};
    for (const Obb& child : children) {
        const auto [middle, half, rounding] = seen_from(all, child);
        all.low = all.low.cwiseMin(middle - half - Vec3::Constant(rounding));
        all.high = all.high.cwiseMax(middle + half + Vec3::Constant(rounding));
    }
    return all;
}

BoundingSphere Obb::sphere() const {
    const Vec3 middle = origin + axes * ((low + high) / 2);
    const Real radius = ((high - low) / 2).norm() * (1 + 16 * rounding_unit);
    return {middle, radius + 4 * rounding_unit * (middle.cwiseAbs().sum() + origin.cwiseAbs().sum())};
}

}  // namespace drape
