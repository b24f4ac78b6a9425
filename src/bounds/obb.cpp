#include "drape/bounds/obb.h"

#include <Eigen/Geometry>

#include "drape/base/assert.h"
#include "extent_kernels.h"

namespace drape {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

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

/// From the first column to the last, and from the first row to the last: the sums of all steps between neighbours
/// along rows and along columns.
BoxAxes axes_of(const Patch& patch) {
    Vec3 along = Vec3::Zero(), across = Vec3::Zero();
    for (int j = 0; j < patch.rows; ++j) along += patch.at(patch.columns - 1, j) - patch.at(0, j);
    for (int i = 0; i < patch.columns; ++i) across += patch.at(i, patch.rows - 1) - patch.at(i, 0);
    return make_axes(along, across);
}

}  // namespace

Obb Obb::fit(const Patch& patch) {
    Obb box;
    box.origin = patch.at(0, 0);
    box.axes = axes_of(patch);
    kernels::extents_along(patch, box.origin, box.axes, box.low.data(), box.high.data());
    const Real rounding = 8 * epsilon * (box.high - box.low).sum();
    box.low.array() -= rounding;
    box.high.array() += rounding;
    return box;
}

Obb Obb::merge(std::span<const Obb> parts) {
    DRAPE_ASSERT(!parts.empty());
    // The same axis of two parts may point in opposite ways
    const BoxAxes& first = parts[0].axes;
    Vec3 along = Vec3::Zero(), across = Vec3::Zero();
    for (const Obb& part : parts) {
        const BoxAxes& axes = part.axes;
        along += axes.col(0).dot(first.col(0)) < 0 ? Vec3(-axes.col(0)) : Vec3(axes.col(0));
        across += axes.col(1).dot(first.col(1)) < 0 ? Vec3(-axes.col(1)) : Vec3(axes.col(1));
    }
    Obb all;
    all.origin = parts[0].origin;
    all.axes = make_axes(along, across);

    // Each part reaches as far from its middle as its edges do together
    all.low.setConstant(std::numeric_limits<Real>::infinity());
    all.high = -all.low;
    for (const Obb& part : parts) {
        const BoxAxes turn = all.axes.transpose() * part.axes;
        const Vec3 offset = part.origin - all.origin;
        const Vec3 middle = all.axes.transpose() * offset + turn * ((part.low + part.high) / 2);
        const Vec3 reach = turn.cwiseAbs() * ((part.high - part.low) / 2);
        const Real rounding =
            16 * epsilon * (offset.cwiseAbs().sum() + part.low.cwiseAbs().sum() + part.high.cwiseAbs().sum());
        all.low = all.low.cwiseMin(middle - reach - Vec3::Constant(rounding));
        all.high = all.high.cwiseMax(middle + reach + Vec3::Constant(rounding));
    }
    return all;
}

BoundingSphere Obb::sphere() const {
    const Vec3 middle = origin + axes * ((low + high) / 2);
    const Real radius = ((high - low) / 2).norm() * (1 + 16 * epsilon);
    return {middle, radius + 4 * epsilon * (middle.cwiseAbs().sum() + origin.cwiseAbs().sum())};
}

}  // namespace drape
