#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// Three directions of length 1, each at right angles to the others, as columns.
using BoxAxes = Eigen::Matrix<Real, 3, 3>;

/// A box that is turned with the cloth: along the mean directions of the patch's rows and columns. @cite gottschalk1996
/// Coordinates along them are measured from one of its own particles, so that they are as exact as the patch is small,
/// however far out it is.
struct Obb {
    Vec3 origin = Vec3::Zero();          ///< a particle of the patch
    BoxAxes axes = BoxAxes::Identity();  ///< orthonormal, even of a patch that is a line or a point
    Vec3 low = Vec3::Zero();             ///< along the axes from the origin, grown by the rounding
    Vec3 high = Vec3::Zero();

    /// The smallest box along those directions a_k: low_k = min a_k . (x_p - origin), high_k = max a_k . (x_p -
    /// origin).
    /// @par Cost O(particles of the patch), one pass
    static Obb fit(const Patch& patch) {
        Obb box = start(patch);
        for_each_particle(patch, [&](const Vec3& p) {
            const Vec3 along = box.axes.transpose() * (p - box.origin);
            box.low = box.low.cwiseMin(along);
            box.high = box.high.cwiseMax(along);
        });
        box.grow_by_rounding();
        return box;
    }

    /// A box without points, along the patch's directions: low and high are left empty, from infinity down to
    /// -infinity.
    static Obb start(const Patch& patch) {
        // From the first column to the last, and from the first row to the last: the sums of all steps between
        // neighbours
        Vec3 along = Vec3::Zero(), across = Vec3::Zero();
        for (int j = 0; j < patch.rows; ++j) along += patch.at(patch.columns - 1, j) - patch.at(0, j);
        for (int i = 0; i < patch.columns; ++i) across += patch.at(i, patch.rows - 1) - patch.at(i, 0);
        return empty(patch.at(0, 0), along, across);
    }

    /// Grows along its directions by just as much as a point needs, and the rounding.
    void include(const Vec3& p) {
        const Vec3 offset = p - origin, along = axes.transpose() * offset;
        const Vec3 rounding = Vec3::Constant(8 * epsilon * offset.cwiseAbs().sum());
        low = low.cwiseMin(along - rounding);
        high = high.cwiseMax(along + rounding);
    }

    /// Makes up for the rounding of coordinates along the axes.
    void grow_by_rounding() {
        const Real rounding = 8 * epsilon * (high - low).sum();
        low.array() -= rounding;
        high.array() += rounding;
    }

    /// The smallest box about boxes along their mean directions. @pre one child or more
    static Obb merge(std::span<const Obb> children) {
        DRAPE_ASSERT(!children.empty());
        // The same axis of two boxes may point in opposite ways
        const BoxAxes& first = children[0].axes;
        Vec3 along = Vec3::Zero(), across = Vec3::Zero();
        for (const Obb& child : children) {
            along += child.axes.col(0).dot(first.col(0)) < 0 ? Vec3(-child.axes.col(0)) : Vec3(child.axes.col(0));
            across += child.axes.col(1).dot(first.col(1)) < 0 ? Vec3(-child.axes.col(1)) : Vec3(child.axes.col(1));
        }
        Obb all = empty(children[0].origin, along, across);
        for (const Obb& child : children) {
            const auto [middle, half, rounding] = all.seen(child);
            all.low = all.low.cwiseMin(middle - half - Vec3::Constant(rounding));
            all.high = all.high.cwiseMax(middle + half + Vec3::Constant(rounding));
        }
        return all;
    }

    /// By the distance of the ball's centre from the box, in the box's directions.
    [[nodiscard]] bool overlaps(const Ball& ball) const {
        const Vec3 offset = ball.centre - origin;
        Real square = 0;
        for (int k = 0; k < 3; ++k) {
            const Real along = axes(0, k) * offset[0] + axes(1, k) * offset[1] + axes(2, k) * offset[2];
            const Real beyond = std::max(Real(0), std::max(low[k] - along, along - high[k]));
            square += beyond * beyond;
        }
        const Real radius = ball.radius * (1 + 16 * epsilon) + 8 * epsilon * offset.cwiseAbs().sum();
        return square <= radius * radius;
    }

    /// By the gaps along the directions of both: those of the nine pairs of edges are left out, which cost more than
    /// they prune. @cite gottschalk1996
    [[nodiscard]] bool comes_within(const Obb& other, Real margin) const {
        return !keeps_away(other, margin) && !other.keeps_away(*this, margin);
    }

    /// About the middle, through the corners.
    [[nodiscard]] BoundingSphere sphere() const {
        const Vec3 middle = origin + axes * ((low + high) / 2);
        const Real radius = ((high - low) / 2).norm() * (1 + 16 * epsilon);
        return {middle, radius + 4 * epsilon * (middle.cwiseAbs().sum() + origin.cwiseAbs().sum())};
    }

private:
    static constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

    /// What of v is at right angles to a direction.
    static Vec3 upright(const Vec3& v, const Vec3& direction) { return v - v.dot(direction) * direction; }

    /// The first axis along `along`, the second as near to `across` as can be. Where these do not say enough, the axes
    /// of space do.
    static Obb empty(const Vec3& origin, const Vec3& along, const Vec3& across) {
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
        const Vec3 infinity = Vec3::Constant(std::numeric_limits<Real>::infinity());
        Obb box{origin, {}, infinity, -infinity};
        box.axes << first, second, first.cross(second);
        return box;
    }

    /// A box as the directions of this one see it: it extends as far from its middle as its edges do together.
    struct SeenBox {
        Vec3 middle, half;
        Real rounding;
    };

    [[nodiscard]] SeenBox seen(const Obb& box) const {
        const BoxAxes turn = axes.transpose() * box.axes;
        const Vec3 offset = box.origin - origin;
        const Vec3 middle = axes.transpose() * offset + turn * ((box.low + box.high) / 2);
        const Vec3 half = turn.cwiseAbs() * ((box.high - box.low) / 2);
        const Real size = offset.cwiseAbs().sum() + box.low.cwiseAbs().sum() + box.high.cwiseAbs().sum();
        return {middle, half, 16 * epsilon * size};
    }

    /// Whether the box keeps another farther away than a margin, along its own directions.
    [[nodiscard]] bool keeps_away(const Obb& other, Real margin) const {
        const auto [middle, half, rounding] = seen(other);
        const Real bound = margin * (1 + 16 * epsilon) + rounding;
        return (middle - half - high).maxCoeff() > bound || (low - middle - half).maxCoeff() > bound;
    }
};

static_assert(BoundingVolume<Obb>);

}  // namespace drape
